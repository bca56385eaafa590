// How far the tool is spread when the joints are: the learned spread of a motion as a tube.
import { toolMmPerDegree } from "./kinematics";
import type { Vec3 } from "./vector";

/** Standard deviation of the flange's place in the direction in which it is largest, for standard
 *  deviations of the joints. To first order, and as if the joints strayed independently: only
 *  their own deviations are known, so this is rather too wide than too narrow. */
export function toolSpreadMm(meanDeg: readonly number[], stdDeg: readonly number[]): number {
  const columns = toolMmPerDegree(meanDeg);
  const part = (row: 0 | 1 | 2, column: 0 | 1 | 2) =>
    columns.reduce((sum, moved, joint) => {
      return sum + moved[row] * moved[column] * (stdDeg[joint] ?? 0) ** 2;
    }, 0);
  const [xx, yy, zz] = [part(0, 0), part(1, 1), part(2, 2)];
  const [xy, xz, yz] = [part(0, 1), part(0, 2), part(1, 2)];
  return Math.sqrt(largestEigenvalue([xx, yy, zz], [yz, xz, xy]));
}

/** Of a symmetric matrix, from its diagonal and from what stands opposite each place of it: the
 *  roots of its characteristic polynomial by the cosine of a third of an angle. */
function largestEigenvalue(diagonal: Vec3, [yz, xz, xy]: Vec3): number {
  const [xx, yy, zz] = diagonal;
  const mean = (xx + yy + zz) / 3;
  const [a, b, c] = [xx - mean, yy - mean, zz - mean];
  const beside = xy * xy + xz * xz + yz * yz;
  const size = Math.sqrt((a * a + b * b + c * c + 2 * beside) / 6);
  if (size === 0) return mean;
  const determinant = a * b * c + 2 * xy * xz * yz - a * yz * yz - b * xz * xz - c * xy * xy;
  const cosine = Math.min(1, Math.max(-1, determinant / (2 * size ** 3)));
  return mean + 2 * size * Math.cos(Math.acos(cosine) / 3);
}
