// The radar plot of the questionnaire: five means from 1 to 5, in words and as a table too.
import type { QuestionnaireResult } from "../api/types";
import { fixed } from "../format/numbers";
import { t } from "../texts";
import { extremes, HIGHEST, onAxis, outline, type Point } from "./radar-shape";

/** The axes in the order in which the server tells the means. */
const AXES = ["learned", "safe", "accurate", "simple", "enjoyable"] as const;

const WIDTH = 336;
const HEIGHT = 226;
const CENTRE: Point = { x: WIDTH / 2, y: 122 };
const RADIUS = 84;

type Anchor = "start" | "middle" | "end";

/** Where the names stand: beside the tips, and never over the drawing. */
const LABELS: readonly (Point & { anchor: Anchor })[] = [
  { x: CENTRE.x, y: 24, anchor: "middle" },
  { x: CENTRE.x + 72, y: 82, anchor: "start" },
  { x: CENTRE.x + 22, y: 216, anchor: "start" },
  { x: CENTRE.x - 22, y: 216, anchor: "end" },
  { x: CENTRE.x - 72, y: 82, anchor: "end" },
];

export function Radar({ title, result }: { title: string; result: QuestionnaireResult }) {
  const { mean, replies } = result;
  const words = sentence(mean, replies);
  return (
    <figure class="radar">
      <figcaption>{title}</figcaption>
      <p>{words}</p>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={`${title}. ${words}`}>
        {[1, 2, 3, 4, 5].map((ring) => (
          <path
            key={ring}
            class="radar-ring"
            d={outline(
              AXES.map(() => ring),
              CENTRE,
              RADIUS,
            )}
          />
        ))}
        {AXES.map((axis, index) => {
          const tip = onAxis(index, AXES.length, 1, CENTRE, RADIUS);
          return (
            <path key={axis} class="radar-ring" d={`M${CENTRE.x} ${CENTRE.y}L${tip.x} ${tip.y}`} />
          );
        })}
        <path class="radar-shape" d={outline(mean, CENTRE, RADIUS)} />
        {mean.map((value, index) => {
          const tip = onAxis(index, mean.length, value / HIGHEST, CENTRE, RADIUS);
          return <circle key={index} class="radar-point" cx={tip.x} cy={tip.y} r="4" />;
        })}
        {AXES.map((axis, index) => {
          const place = LABELS[index]!;
          return (
            <text key={axis} x={place.x} y={place.y} text-anchor={place.anchor}>
              {t.dashboard.axes[axis]}
            </text>
          );
        })}
      </svg>
      <details class="numbers">
        <summary>{t.plot.numbers}</summary>
        <table aria-label={title}>
          <thead>
            <tr>
              <th scope="col">{t.dashboard.statement}</th>
              <th scope="col">{t.dashboard.mean}</th>
            </tr>
          </thead>
          <tbody>
            {AXES.map((axis, index) => (
              <tr key={axis}>
                <th scope="row">{t.feedback.statements[axis]}</th>
                <td>{fixed(mean[index] ?? 0, 1)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </details>
    </figure>
  );
}

/** The plot in one line. */
function sentence(mean: readonly number[], replies: number): string {
  const found = extremes(mean);
  if (!found) return "";
  const name = (index: number) => t.dashboard.axes[AXES[index] ?? "learned"];
  const value = (index: number) => fixed(mean[index] ?? 0, 1);
  if (found.even) return t.dashboard.even(value(found.best), String(replies));
  return t.dashboard.summary(
    name(found.best),
    value(found.best),
    name(found.worst),
    value(found.worst),
    String(replies),
  );
}
