// The record played back: a slider over its time, and the joints at that moment as numbers.
import type { Signal } from "@preact/signals";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Flight } from "../../api/types";
import { Button } from "../../components/button";
import { degrees, duration } from "../../format/numbers";
import { pointAt } from "../../plots/extremes";
import { t } from "../../texts";

export function Replay({ flight, time }: { flight: Flight; time: Signal<number> }) {
  const playing = useSignal(false);
  const endS = flight.end_s;
  useEffect(() => {
    if (!playing.value) return;
    let last = performance.now();
    let frame = requestAnimationFrame(function advance(now) {
      time.value = Math.min(endS, time.peek() + Math.max(0, now - last) / 1000);
      last = now;
      if (time.peek() < endS) frame = requestAnimationFrame(advance);
      else playing.value = false;
    });
    return () => cancelAnimationFrame(frame);
  }, [playing.value, endS]);
  const toggle = () => {
    if (!playing.peek() && time.peek() >= endS) time.value = 0;
    playing.value = !playing.peek();
  };
  const point = pointAt(flight.t_s, time.value);
  const phase = flight.phase[point];
  const words = t.flight.at(duration(time.value), duration(endS));
  return (
    <section class="card replay">
      <h2>{t.flight.replay}</h2>
      <p class="replay-time">
        <strong>{words}</strong>
        {phase && <span>{t.flight.phases[phase] ?? phase}</span>}
      </p>
      <input
        type="range"
        min="0"
        max={endS}
        step="any"
        value={time.value}
        aria-label={t.flight.slider}
        aria-valuetext={words}
        onInput={(event) => {
          playing.value = false;
          time.value = event.currentTarget.valueAsNumber;
        }}
      />
      <Button icon={playing.value ? "pause" : "play"} onPress={toggle}>
        {playing.value ? t.flight.pause : t.flight.play}
      </Button>
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
