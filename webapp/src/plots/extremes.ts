// Lines of a thinned-out record that show its extremes: a spike of one cycle is drawn too.

/** Times with one more between each and the next: that is where the extremes go. */
export function timesWithExtremes(timesS: readonly number[]): number[] {
  return timesS.flatMap((at, point) => {
    const next = timesS[point + 1];
    return next === undefined ? [at] : [at, (at + next) / 2];
  });
}

/** Values for these times: each point's own, then the one of its extremes that is farther off. */
export function valuesWithExtremes(
  values: readonly number[],
  lowest: readonly number[],
  highest: readonly number[],
): number[] {
  return values.flatMap((value, point) => {
    if (point === values.length - 1) return [value];
    const [low, high] = [lowest[point] ?? value, highest[point] ?? value];
    return [value, high - value > value - low ? high : low];
  });
}

/** The last point at or before a time; the first one when there is none. */
export function pointAt(timesS: readonly number[], atS: number): number {
  let [low, high] = [0, Math.max(0, timesS.length - 1)];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (timesS[middle]! <= atS) low = middle;
    else high = middle - 1;
  }
  return low;
}
