// The arm's pose at a time: from a record, and from live samples that come now and then. Between
// two samples a straight line; before the first and after the last nothing is made up.
import { pointAt } from "../plots/extremes";

export type Pose = readonly number[];

/** A motion as the server sends it: times, and one list of angles for each joint. */
export interface Track {
  timesS: readonly number[];
  jointsDeg: readonly (readonly number[])[];
}

export function poseAt(track: Track, atS: number): Pose | null {
  if (track.timesS.length === 0) return null;
  const from = pointAt(track.timesS, atS);
  const to = Math.min(from + 1, track.timesS.length - 1);
  const [early, late] = [track.timesS[from]!, track.timesS[to]!];
  const share = late > early ? Math.min(1, Math.max(0, (atS - early) / (late - early))) : 0;
  return track.jointsDeg.map((line) => line[from]! + share * (line[to]! - line[from]!));
}

/** At most `most` poses of a motion, evenly spread, with its first and its last. */
export function somePoses(track: Track, most: number): Pose[] {
  const points = track.timesS.length;
  const count = Math.min(points, most);
  const at = (n: number) => (count > 1 ? Math.round((n * (points - 1)) / (count - 1)) : 0);
  return Array.from({ length: count }, (_, n) => track.jointsDeg.map((line) => line[at(n)]!));
}

/** The part of a motion between two times. */
export function between(track: Track, fromS: number, toS: number): Track {
  const kept = track.timesS.flatMap((at, point) => (at >= fromS && at <= toS ? [point] : []));
  const pick = (line: readonly number[]) => kept.map((point) => line[point]!);
  return { timesS: pick(track.timesS), jointsDeg: track.jointsDeg.map(pick) };
}

/** How long after it was measured a live pose is shown: two samples of a slow network, so that
 *  there is mostly a next one to go to. */
export const LAG_S = 0.1;
/** Samples further apart were interrupted: what the arm did between them nobody knows. */
const GAP_S = 0.5;
const KEPT = 16;

/** The last live samples, to be shown a moment later as an even movement. */
export class LivePose {
  private samples: { atS: number; pose: Pose }[] = [];

  push(atS: number, pose: Pose): void {
    const newest = this.samples.at(-1);
    if (newest && atS <= newest.atS) return;
    if (newest && atS - newest.atS > GAP_S) this.samples = [];
    this.samples = [...this.samples.slice(1 - KEPT), { atS, pose }];
  }

  clear(): void {
    this.samples = [];
  }

  at(nowS: number): Pose | null {
    const wantedS = nowS - LAG_S;
    const next = this.samples.findIndex((sample) => sample.atS > wantedS);
    if (next < 0) return this.samples.at(-1)?.pose ?? null;
    const [a, b] = [this.samples[Math.max(0, next - 1)]!, this.samples[next]!];
    const share = b.atS > a.atS ? (wantedS - a.atS) / (b.atS - a.atS) : 1;
    return a.pose.map((angle, joint) => angle + share * (b.pose[joint]! - angle));
  }

  /** Whether later times show the same until another sample comes. */
  settled(nowS: number): boolean {
    return (this.samples.at(-1)?.atS ?? -Infinity) <= nowS - LAG_S;
  }
}
