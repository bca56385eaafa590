// Six small plots, one for each joint: told apart by place and name, so colour carries nothing.
import type { ReadonlySignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type uPlot from "uplot";
import type { Trim } from "../api/types";
import { degrees } from "../format/numbers";
import { t } from "../texts";
import { axisNumbers } from "./axis-numbers";
import { AXIS_FONT, Chart, PLAIN } from "./chart";
import { colour } from "./colours";
import { drawCut, drawLine, useCursor } from "./cursor";
import { NumbersTable } from "./numbers-table";
import { paddedRange, sentence, summarise } from "./summary";

export interface Layer {
  label: string;
  /** One list of angles for each joint. */
  joints: number[][];
  look: "strong" | "thin" | "dashed";
}

interface Props {
  title: string;
  timesS: number[];
  layers: Layer[];
  /** Half the height of a band around the first layer, for each joint. */
  bandDeg?: number[][];
  /** Where the motion proper begins: a vertical line. */
  markS?: number;
  /** Where signals are worked: vertical lines of their own. */
  signalsS?: number[];
  /** A time that moves: a second line. */
  cursor?: ReadonlySignal<number>;
  /** The stretch that is used; what lies outside is veiled. */
  cut?: ReadonlySignal<Trim>;
}

export function JointPanels(props: Props) {
  const { title, timesS, layers, bandDeg, markS, signalsS, cursor, cut } = props;
  const main = layers[0]?.joints ?? [];
  return (
    <figure class="panels">
      <figcaption>{title}</figcaption>
      {layers.length > 1 && <Legend layers={layers} />}
      <div class="panel-grid" role="img" aria-label={sentence(title, timesS, main)}>
        {main.map((_, joint) => (
          <Panel
            key={joint}
            {...{ timesS, layers, bandDeg, markS, signalsS, cursor, cut, joint }}
          />
        ))}
      </div>
      <NumbersTable caption={title} joints={main} />
    </figure>
  );
}

interface PanelProps {
  timesS: number[];
  layers: Layer[];
  bandDeg: number[][] | undefined;
  markS: number | undefined;
  signalsS: number[] | undefined;
  cursor: ReadonlySignal<number> | undefined;
  cut: ReadonlySignal<Trim> | undefined;
  joint: number;
}

function Panel(props: PanelProps) {
  const { timesS, layers, bandDeg, markS, signalsS, cursor, cut, joint } = props;
  const band = bandDeg?.[joint];
  const data = useMemo<uPlot.AlignedData>(() => {
    const lines = layers.map((layer) => layer.joints[joint] ?? []);
    const main = lines[0] ?? [];
    const edges = band
      ? [main.map((value, at) => value + band[at]!), main.map((value, at) => value - band[at]!)]
      : [];
    return [timesS, ...edges, ...lines];
  }, [timesS, layers, band, joint]);
  const options = () => panelOptions(layers, band !== undefined, markS, signalsS, cursor, cut);
  const onCursor = useCursor(cursor);
  const onCut = useCursor(cut);
  const onReady = (plot: uPlot) => {
    onCursor(plot);
    onCut(plot);
  };
  const summary = summarise(layers[0]?.joints[joint] ?? []);
  return (
    <div class="panel">
      <p class="panel-name">
        <strong>{t.plot.short(joint + 1)}</strong>
        {summary && <span>{degrees(summary.highest - summary.lowest, 0)}</span>}
      </p>
      <Chart options={options} data={data} height={120} onReady={onReady} />
    </div>
  );
}

function panelOptions(
  layers: Layer[],
  banded: boolean,
  markS: number | undefined,
  signalsS: number[] = [],
  cursor: ReadonlySignal<number> | undefined,
  cut: ReadonlySignal<Trim> | undefined,
) {
  const edge: uPlot.Series = { stroke: "transparent", points: { show: false } };
  const lines = layers.map((layer) => ({
    stroke: colour(layer.look === "dashed" ? "plot-second" : "plot-first"),
    width: layer.look === "thin" ? 1 : 2,
    dash: layer.look === "dashed" ? [5, 4] : [],
    points: { show: false },
  }));
  const axis = {
    stroke: colour("plot-axis"),
    font: AXIS_FONT,
    values: axisNumbers,
    grid: { stroke: colour("plot-grid"), width: 1 },
  };
  const options: Omit<uPlot.Options, "width" | "height"> = {
    ...PLAIN,
    padding: [6, 8, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => paddedRange(low, high) } },
    series: [{}, ...(banded ? [edge, edge] : []), ...lines],
    axes: [
      { ...axis, size: 24, gap: 2, space: 44, ticks: { show: false } },
      { ...axis, size: 40, gap: 4, space: 32, ticks: { show: false } },
    ],
  };
  if (banded) options.bands = [{ series: [1, 2], fill: colour("plot-band") }];
  const drawLines = (plot: uPlot) => {
    if (markS !== undefined) drawLine(plot, markS, colour("plot-axis"), [2, 4]);
    signalsS.forEach((atS) => drawLine(plot, atS, colour("plot-axis"), []));
    if (cut) drawCut(plot, cut.peek(), colour("plot-veil"), colour("text"));
    if (cursor) drawLine(plot, cursor.peek(), colour("text"), []);
  };
  options.hooks = { draw: [drawLines] };
  return options;
}

function Legend({ layers }: { layers: Layer[] }) {
  return (
    <p class="legend">
      {layers.map((layer) => (
        <span key={layer.label}>
          <i class={`legend-line legend-${layer.look}`} aria-hidden="true" />
          {layer.label}
        </span>
      ))}
    </p>
  );
}
