// The last few seconds of joint angles for the live traces: fixed memory, oldest dropped first.

export const JOINTS = 6;

export class JointRing {
  private readonly times: Float64Array;
  private readonly values: Float64Array[];
  private next = 0;
  private filled = 0;
  private changes = 0;

  constructor(readonly capacity: number) {
    this.times = new Float64Array(capacity);
    this.values = Array.from({ length: JOINTS }, () => new Float64Array(capacity));
  }

  get length(): number {
    return this.filled;
  }

  /** Another number after every change: what was drawn at the same one need not be drawn again. */
  get revision(): number {
    return this.changes;
  }

  clear(): void {
    this.changes += 1;
    this.next = 0;
    this.filled = 0;
  }

  /** Adds one sample. One that is not later than the last is left out: time must run forward. */
  push(timeS: number, joints: readonly number[]): void {
    if (joints.length < JOINTS) return;
    if (this.filled > 0 && timeS <= this.newest()) return;
    this.changes += 1;
    this.times[this.next] = timeS;
    this.values.forEach((column, joint) => (column[this.next] = joints[joint]!));
    this.next = (this.next + 1) % this.capacity;
    this.filled = Math.min(this.filled + 1, this.capacity);
  }

  /** Oldest to newest of the last `windowS` seconds: times relative to the newest sample, joints. */
  window(windowS: number): [number[], ...number[][]] {
    const rows: number[] = [];
    const newest = this.filled > 0 ? this.newest() : 0;
    for (let age = this.filled; age >= 1; age -= 1) {
      const index = (this.next - age + this.capacity) % this.capacity;
      if (newest - this.times[index]! <= windowS) rows.push(index);
    }
    const pick = (column: Float64Array, offset: number) =>
      rows.map((index) => column[index]! - offset);
    return [pick(this.times, newest), ...this.values.map((column) => pick(column, 0))];
  }

  private newest(): number {
    return this.times[(this.next - 1 + this.capacity) % this.capacity]!;
  }
}
