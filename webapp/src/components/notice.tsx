// Messages inside a screen: problems, loading, and short remarks with a state.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { Problem } from "../api/problem";
import type { Load } from "../state/hooks";
import { t } from "../texts";
import { Button } from "./button";
import { Icon, type IconName } from "./icon";

export type NoticeTone = "good" | "bad" | "soft" | "moving" | "plain";

interface NoticeProps {
  tone: NoticeTone;
  icon: IconName;
  title?: string;
  children?: ComponentChildren;
}

export function Notice({ tone, icon, title, children }: NoticeProps) {
  return (
    <div class={`notice tone-${tone}`}>
      <Icon name={icon} />
      <div>
        {title && <strong>{title}</strong>}
        {children}
      </div>
    </div>
  );
}

interface ProblemProps {
  problem: { detail?: string; message?: string; advice: string; where?: string | null } | Problem;
  title?: string;
  onRetry?: (() => void) | undefined;
}

/** What was wrong, where, and what to do. */
export function ProblemNotice({ problem, title, onRetry }: ProblemProps) {
  const what = problem.detail || problem.message;
  const place = useRef<HTMLDivElement>(null);
  // What was pressed may be far below; the answer must not go unseen.
  useEffect(() => place.current?.scrollIntoView({ block: "nearest" }), [problem]);
  return (
    <div ref={place} class="notice tone-bad" role="alert">
      <Icon name="alert" />
      <div>
        {title && <strong>{title}</strong>}
        <dl class="what-to-do">
          <dt>{t.problems.whatWasWrong}</dt>
          <dd>{what}</dd>
          {problem.where && (
            <>
              <dt>{t.problems.where}</dt>
              <dd>{problem.where}</dd>
            </>
          )}
          <dt>{t.problems.whatToDo}</dt>
          <dd>{problem.advice}</dd>
        </dl>
        {onRetry && (
          <Button icon="again" onPress={onRetry}>
            {t.app.tryAgain}
          </Button>
        )}
      </div>
    </div>
  );
}

/** Shows that something is being loaded, or why it could not be. */
export function LoadNotice({ load, empty }: { load: Load; empty: boolean }) {
  if (load.problem) return <ProblemNotice problem={load.problem} onRetry={load.again} />;
  if (!load.loading || !empty) return null;
  return (
    <p class="loading" role="status">
      <span class="spinner" aria-hidden="true" />
      {t.app.loading}
    </p>
  );
}
