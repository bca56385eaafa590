// What happened the last times a task was run, as ways to the records.
import { listReproductions } from "../../api/endpoints";
import { RowLink } from "../../components/row-link";
import { RunState, Worked } from "../../components/run-state";
import { moment } from "../../format/when";
import { reproductions } from "../../state/entities";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";

const SHOWN = 3;
/** Ways back are among those that are listed, and are left out here. */
const ASKED = 3 * SHOWN;

export function RecentRuns({ task }: { task: string }) {
  // The page is complete without them, so a failure says nothing.
  useLoad(async () => reproductions.put(...(await listReproductions(task, ASKED))), task);
  const latest = reproductions
    .where((one) => one.task_id === task && !one.backwards)
    .sort((one, other) => other.created_at.localeCompare(one.created_at))
    .slice(0, SHOWN);
  if (latest.length === 0) return null;
  return (
    <section class="recent">
      <h2>{t.feedback.recent}</h2>
      <ul class="rows">
        {latest.map((one) => (
          <RowLink key={one.id} to={{ page: "motion", task, motion: one.id }}>
            <span class="row-name">
              <strong>{moment(one.created_at)}</strong>{" "}
              <span class="row-states">
                <RunState state={one.state} />{" "}
                {one.outcome && <Worked worked={one.outcome.worked} />}
              </span>
            </span>
          </RowLink>
        ))}
      </ul>
    </section>
  );
}
