// A vertical line in a drawing, and one that moves with a signal without drawing the rest anew.
import { useSignalEffect, type ReadonlySignal } from "@preact/signals";
import { useCallback, useRef } from "preact/hooks";
import type uPlot from "uplot";

export function drawLine(plot: uPlot, atS: number, stroke: string, dash: number[]): void {
  const x = Math.round(plot.valToPos(atS, "x", true));
  const { top, height } = plot.bbox;
  plot.ctx.save();
  plot.ctx.strokeStyle = stroke;
  plot.ctx.setLineDash(dash);
  plot.ctx.lineWidth = dash.length === 0 ? 2 : 1;
  plot.ctx.beginPath();
  plot.ctx.moveTo(x, top);
  plot.ctx.lineTo(x, top + height);
  plot.ctx.stroke();
  plot.ctx.restore();
}

/** To be handed to a chart: it is painted again whenever the time changes. */
export function useCursor(time: ReadonlySignal<number> | undefined): (plot: uPlot) => void {
  const plot = useRef<uPlot | null>(null);
  useSignalEffect(() => {
    void time?.value;
    plot.current?.redraw(false, false);
  });
  return useCallback((made: uPlot) => {
    plot.current = made;
  }, []);
}
