// All joints of the last ten seconds, drawn at the screen's own rate straight from the ring
// buffer: the app's state is not touched sixty times a second.
import { useEffect, useRef } from "preact/hooks";
import type uPlot from "uplot";
import { recentJoints } from "../state/live";
import { JointRing } from "../live/ring-buffer";
import { t } from "../texts";
import { axisNumbers, axisSeconds } from "./axis-numbers";
import { AXIS_FONT, Chart, PLAIN } from "./chart";
import { colour } from "./colours";
import { JointLegend, jointSeries } from "./joint-legend";

const WINDOW_S = 10;
const EMPTY: uPlot.AlignedData = new JointRing(1).window(0);

export function LiveTraces() {
  const plot = useRef<uPlot | null>(null);
  useEffect(() => {
    let drawn: readonly [uPlot | null, number] = [null, -1];
    let frame = requestAnimationFrame(function draw() {
      const wanted = [plot.current, recentJoints.revision] as const;
      if (wanted[0] !== drawn[0] || wanted[1] !== drawn[1]) {
        plot.current?.setData(recentJoints.window(WINDOW_S));
        drawn = wanted;
      }
      frame = requestAnimationFrame(draw);
    });
    return () => cancelAnimationFrame(frame);
  }, []);
  return (
    <figure class="live-traces">
      <div role="img" aria-label={t.plot.live}>
        <Chart
          options={options}
          data={EMPTY}
          height={200}
          onReady={(made) => (plot.current = made)}
        />
      </div>
      <JointLegend />
    </figure>
  );
}

function options(): Omit<uPlot.Options, "width" | "height"> {
  const axis = { stroke: colour("plot-axis"), font: AXIS_FONT, ticks: { show: false } };
  return {
    ...PLAIN,
    padding: [6, 18, 0, 0],
    scales: { x: { time: false, range: () => [-WINDOW_S, 0] } },
    series: jointSeries(),
    axes: [
      {
        ...axis,
        size: 24,
        gap: 2,
        grid: { show: false },
        values: axisSeconds,
      },
      {
        ...axis,
        values: axisNumbers,
        size: 48,
        gap: 4,
        grid: { stroke: colour("plot-grid"), width: 1 },
      },
    ],
  };
}
