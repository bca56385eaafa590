// One uPlot drawing that fits its place and follows size, data and colour scheme.
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { scheme } from "./colours";

interface Props {
  /** Made anew for each drawing, so that it can read the present colours. */
  options: () => Omit<uPlot.Options, "width" | "height">;
  data: uPlot.AlignedData;
  height: number;
  /** Handed the drawing, for data that changes many times a second. */
  onReady?: (plot: uPlot) => void;
}

export function Chart({ options, data, height, onReady }: Props) {
  const place = useRef<HTMLDivElement>(null);
  const look = scheme.value;
  useEffect(() => {
    const element = place.current;
    if (!element) return;
    const size = () => ({ width: Math.max(1, element.clientWidth), height });
    const plot = new uPlot({ ...options(), ...size() }, data, element);
    onReady?.(plot);
    const watch = new ResizeObserver(() => plot.setSize(size()));
    watch.observe(element);
    return () => {
      watch.disconnect();
      plot.destroy();
    };
  }, [data, height, look]);
  return <div class="chart" ref={place} style={{ height: `${height}px` }} aria-hidden="true" />;
}

/** Settings that all our drawings share: no legend and no cursor, for gloves cannot hover. */
export const PLAIN: Pick<uPlot.Options, "legend" | "cursor"> = {
  legend: { show: false },
  cursor: { show: false },
};

export const AXIS_FONT = "14px system-ui, sans-serif";
