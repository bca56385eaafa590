// The numbers behind a plot: start, end and extremes of each joint.
import { degrees } from "../format/numbers";
import { t } from "../texts";
import { summarise } from "./summary";

export function NumbersTable({ caption, joints }: { caption: string; joints: number[][] }) {
  return (
    <details class="numbers">
      <summary>{t.plot.numbers}</summary>
      <table aria-label={caption}>
        <thead>
          <tr>
            <td />
            {[t.plot.start, t.plot.end, t.plot.lowest, t.plot.highest].map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {joints.map((values, joint) => {
            const row = summarise(values);
            return (
              row && (
                <tr key={joint}>
                  <th scope="row" aria-label={t.plot.joint(joint + 1)}>
                    {t.plot.short(joint + 1)}
                  </th>
                  <td>{degrees(row.start)}</td>
                  <td>{degrees(row.end)}</td>
                  <td>{degrees(row.lowest)}</td>
                  <td>{degrees(row.highest)}</td>
                </tr>
              )
            );
          })}
        </tbody>
      </table>
    </details>
  );
}
