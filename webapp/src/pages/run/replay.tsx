// The record played back: the arm at a time of the motion, and its joints at that moment as numbers.
import type { Signal } from "@preact/signals";
import type { Flight } from "../../api/types";
import { ReplaySlider } from "../../components/replay-slider";
import { FlightPicture } from "../../arm3d/flight-picture";
import { degrees } from "../../format/numbers";
import { pointAt } from "../../plots/extremes";
import { t } from "../../texts";

export function Replay({ flight, time }: { flight: Flight; time: Signal<number> }) {
  const point = pointAt(flight.t_s, time.value);
  const phase = flight.phase[point];
  return (
    <section class="replay">
      <h2>{t.flight.replay}</h2>
      <FlightPicture flight={flight} time={time}>
        <ReplaySlider time={time} endS={flight.end_s}>
          {phase && <span>{t.flight.phases[phase] ?? phase}</span>}
        </ReplaySlider>
      </FlightPicture>
      <JointsAt flight={flight} point={point} />
    </section>
  );
}

function JointsAt({ flight, point }: { flight: Flight; point: number }) {
  return (
    <div class="numbers">
      <table aria-label={t.flight.jointsAt}>
        <thead>
          <tr>
            <th scope="col">{t.flight.joint}</th>
            <th scope="col">{t.flight.planned}</th>
            <th scope="col">{t.flight.measured}</th>
            <th scope="col">{t.flight.off}</th>
          </tr>
        </thead>
        <tbody>
          {flight.measured_deg.map((angles, joint) => {
            const measured = angles[point] ?? 0;
            const commanded = flight.commanded_deg[joint]?.[point] ?? 0;
            return (
              <tr key={joint}>
                <th scope="row" aria-label={t.plot.joint(joint + 1)}>
                  {t.plot.short(joint + 1)}
                </th>
                <td>{degrees(commanded, 1)}</td>
                <td>{degrees(measured, 1)}</td>
                <td>{degrees(Math.abs(commanded - measured), 2)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
