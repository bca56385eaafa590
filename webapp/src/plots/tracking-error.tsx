// How far each joint was off over time, with a mark wherever messages were lost or came late.
import type { ReadonlySignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type uPlot from "uplot";
import { degrees } from "../format/numbers";
import { t } from "../texts";
import { axisNumbers } from "./axis-numbers";
import { AXIS_FONT, Chart, PLAIN } from "./chart";
import { colour } from "./colours";
import { drawLine, useCursor } from "./cursor";
import { JointLegend, jointSeries } from "./joint-legend";

interface Props {
  timesS: number[];
  /** For each joint, the largest distance of the measured from the commanded angle. */
  errorsDeg: number[][];
  /** When messages were lost or came late. */
  marksS: number[];
  cursor: ReadonlySignal<number>;
}

export function TrackingError({ timesS, errorsDeg, marksS, cursor }: Props) {
  const data = useMemo<uPlot.AlignedData>(() => [timesS, ...errorsDeg], [timesS, errorsDeg]);
  const onReady = useCursor(cursor);
  const most = errorsDeg.map((errors) => errors.reduce((a, b) => Math.max(a, b), 0));
  const joint = most.indexOf(Math.max(...most));
  const words = t.flight.errorSummary(joint + 1, degrees(most[joint] ?? 0, 2));
  return (
    <figure class="live-traces">
      <figcaption class="plot-title">{t.flight.errorPlot}</figcaption>
      <div role="img" aria-label={words}>
        <Chart options={() => options(marksS, cursor)} data={data} height={170} onReady={onReady} />
      </div>
      <JointLegend />
      {marksS.length > 0 && <p>{t.flight.marks}</p>}
    </figure>
  );
}

function options(marksS: readonly number[], cursor: ReadonlySignal<number>) {
  const axis = {
    stroke: colour("plot-axis"),
    font: AXIS_FONT,
    ticks: { show: false },
    values: axisNumbers,
  };
  const grid = { stroke: colour("plot-grid"), width: 1 };
  const options: Omit<uPlot.Options, "width" | "height"> = {
    ...PLAIN,
    padding: [6, 8, 0, 0],
    // Half a degree at least, so that noise does not look large.
    scales: { x: { time: false }, y: { range: (_, __, high) => [0, Math.max(0.5, high * 1.1)] } },
    series: jointSeries(),
    axes: [
      { ...axis, size: 24, gap: 2, space: 44, grid },
      { ...axis, size: 48, gap: 4, space: 32, grid },
    ],
    hooks: {
      draw: [
        (plot) => {
          marksS.forEach((at) => drawLine(plot, at, colour("bad"), [3, 5]));
          drawLine(plot, cursor.peek(), colour("text"), []);
        },
      ],
    },
  };
  return options;
}
