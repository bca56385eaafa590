import { describe, expect, it } from "vitest";
import { between, LAG_S, LivePose, poseAt, somePoses, type Track } from "./poses";

const TRACK: Track = {
  timesS: [0, 1, 3],
  jointsDeg: [
    [0, 10, 30],
    [5, 5, -5],
  ],
};

describe("a recorded motion", () => {
  it("is a straight line between its samples and stands still outside of them", () => {
    expect(poseAt(TRACK, 0.5)).toEqual([5, 5]);
    expect(poseAt(TRACK, 2)).toEqual([20, 0]);
    expect(poseAt(TRACK, -1)).toEqual([0, 5]);
    expect(poseAt(TRACK, 9)).toEqual([30, -5]);
    expect(poseAt({ timesS: [], jointsDeg: [[], []] }, 1)).toBeNull();
  });

  it("is thinned out with both of its ends", () => {
    const long: Track = {
      timesS: Array.from({ length: 1000 }, (_, at) => at),
      jointsDeg: [Array.from({ length: 1000 }, (_, at) => at)],
    };
    const some = somePoses(long, 11);
    expect(some).toHaveLength(11);
    expect([some[0], some.at(-1)]).toEqual([[0], [999]]);
    expect(somePoses(TRACK, 100)).toHaveLength(3);
  });

  it("is cut between two times", () => {
    expect(between(TRACK, 1, Infinity)).toEqual({
      timesS: [1, 3],
      jointsDeg: [
        [10, 30],
        [5, -5],
      ],
    });
  });
});

describe("the live arm", () => {
  it("goes evenly from sample to sample, a moment late", () => {
    const live = new LivePose();
    live.push(1, [0]);
    live.push(1.05, [10]);
    live.push(1.1, [10]);
    expect(live.at(1 + LAG_S)).toEqual([0]);
    expect(live.at(1.025 + LAG_S)?.[0]).toBeCloseTo(5);
    expect(live.at(1.08 + LAG_S)?.[0]).toBeCloseTo(10);
  });

  it("never goes on beyond the last sample", () => {
    const live = new LivePose();
    expect(live.at(5)).toBeNull();
    live.push(1, [0]);
    live.push(1.04, [8]);
    expect(live.settled(1.1)).toBe(false);
    expect(live.at(7)).toEqual([8]);
    expect(live.settled(7)).toBe(true);
  });

  it("does not glide over an interruption", () => {
    const live = new LivePose();
    live.push(1, [0]);
    live.push(4, [50]);
    expect(live.at(2.5)).toEqual([50]);
  });

  it("leaves out samples that are not later", () => {
    const live = new LivePose();
    live.push(2, [1]);
    live.push(1.9, [99]);
    expect(live.at(9)).toEqual([1]);
  });
});
