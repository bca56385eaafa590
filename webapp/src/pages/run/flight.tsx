// The flight record: played back over its plots, told in events, and taken away as files.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { flightFile, getFlight, getFlightEvents } from "../../api/endpoints";
import type { Flight, FlightEvent, Reproduction } from "../../api/types";
import { Icon } from "../../components/icon";
import { LoadNotice } from "../../components/notice";
import { SignalTimes } from "../../components/signal-times";
import { duration } from "../../format/numbers";
import { timesWithExtremes, valuesWithExtremes } from "../../plots/extremes";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { TrackingError } from "../../plots/tracking-error";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { Replay } from "./replay";

const POINTS = 400;

export function FlightRecord({ motion }: { motion: Reproduction }) {
  const flight = useSignal<Flight | null>(null);
  const events = useSignal<FlightEvent[]>([]);
  const load = useLoad(async () => {
    [flight.value, events.value] = await Promise.all([
      getFlight(motion.id, POINTS),
      getFlightEvents(motion.id),
    ]);
  }, motion.id);
  const shown = flight.value;
  return (
    <>
      <LoadNotice load={load} empty={shown === null} />
      {shown && (shown.t_s.length > 0 ? <Drawn flight={shown} /> : <p>{t.flight.none}</p>)}
      <Events list={events.value} />
      {shown && shown.t_s.length > 0 && <Files id={motion.id} />}
    </>
  );
}

function Drawn({ flight }: { flight: Flight }) {
  const time = useSignal(0);
  const { timesS, layers, marksS } = useMemo(() => drawingOf(flight), [flight]);
  return (
    <>
      <Replay flight={flight} time={time} />
      <JointPanels
        title={t.run.measuredPlot}
        timesS={timesS}
        layers={layers}
        signalsS={flight.signals.map((signal) => signal.at_s)}
        cursor={time}
      />
      <SignalTimes title={t.signals.done} marks={flight.signals} />
      <TrackingError
        timesS={flight.t_s}
        errorsDeg={flight.error_max_deg}
        marksS={marksS}
        cursor={time}
      />
    </>
  );
}

function drawingOf(flight: Flight) {
  const lines = (values: number[][], lowest: number[][], highest: number[][]) =>
    values.map((own, joint) => valuesWithExtremes(own, lowest[joint] ?? [], highest[joint] ?? []));
  const layers: Layer[] = [
    {
      label: t.run.measured,
      joints: lines(flight.measured_deg, flight.measured_min_deg, flight.measured_max_deg),
      look: "strong",
    },
    {
      label: t.run.planned,
      joints: lines(flight.commanded_deg, flight.commanded_min_deg, flight.commanded_max_deg),
      look: "dashed",
    },
  ];
  const marksS = flight.t_s.filter(
    (_, point) => (flight.lost[point] ?? 0) + (flight.late[point] ?? 0) > 0,
  );
  return { timesS: timesWithExtremes(flight.t_s), layers, marksS };
}

function Events({ list }: { list: readonly FlightEvent[] }) {
  if (list.length === 0) return null;
  return (
    <section class="events">
      <h2>{t.flight.events}</h2>
      <ol>
        {list.map((event, position) => (
          <li key={position}>
            <span class="event-time">{duration(event.at_s)}</span>
            <span>{event.message}</span>
          </li>
        ))}
      </ol>
    </section>
  );
}

function Files({ id }: { id: string }) {
  return (
    <section class="files">
      <h2>{t.flight.files}</h2>
      {(["csv", "mcap"] as const).map((kind) => (
        <a key={kind} class="button button-secondary" href={flightFile(id, kind)} download>
          <Icon name="download" />
          <span>{t.flight[kind]}</span>
        </a>
      ))}
    </section>
  );
}
