// A vertical line in a drawing, and one that moves with a signal without drawing the rest anew.
import { useSignalEffect, type ReadonlySignal } from "@preact/signals";
import { useCallback, useRef } from "preact/hooks";
import type uPlot from "uplot";
import type { Trim } from "../api/types";

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

/** What is cut away is covered by a veil, with a line where it ends. */
export function drawCut(plot: uPlot, { from_s, to_s }: Trim, veil: string, line: string): void {
  const { left, top, width, height } = plot.bbox;
  const at = (timeS: number) =>
    Math.min(left + width, Math.max(left, Math.round(plot.valToPos(timeS, "x", true))));
  plot.ctx.save();
  plot.ctx.fillStyle = veil;
  plot.ctx.fillRect(left, top, at(from_s) - left, height);
  plot.ctx.fillRect(at(to_s), top, left + width - at(to_s), height);
  plot.ctx.restore();
  if (at(from_s) > left) drawLine(plot, from_s, line, []);
  if (at(to_s) < left + width) drawLine(plot, to_s, line, []);
}

/** To be handed to a chart: it is painted again whenever what is followed changes. */
export function useCursor(time: ReadonlySignal<unknown> | undefined): (plot: uPlot) => void {
  const plot = useRef<uPlot | null>(null);
  useSignalEffect(() => {
    void time?.value;
    plot.current?.redraw(false, false);
  });
  return useCallback((made: uPlot) => {
    plot.current = made;
  }, []);
}
