// While the arm moves: another speed, a pause. Stop is in the frame of the page, always.
import { changePace } from "../../api/endpoints";
import { Button } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { percent } from "../../format/numbers";
import { useAction } from "../../state/hooks";
import { t } from "../../texts";

/** Shares of the planned speed, one press apart. */
export const PACES = [0.05, 0.1, 0.25, 0.5, 0.75, 1] as const;

/** The next slower or faster pace; the same where there is none. */
export function nextPace(speed: number, faster: boolean): number {
  const next = faster
    ? PACES.find((pace) => pace > speed + 1e-6)
    : PACES.findLast((pace) => pace < speed - 1e-6);
  return next ?? speed;
}

interface Props {
  motion: string;
  speed: number;
  paused: boolean;
}

export function Pace({ motion, speed, paused }: Props) {
  const hold = useAction(() => changePace(motion, { paused: !paused }));
  return (
    <section class="pace" aria-label={t.run.pace.title}>
      {hold.problem && <ProblemNotice problem={hold.problem} />}
      <Button look="primary" icon={paused ? "play" : "pause"} onPress={hold.start}>
        {paused ? t.run.pace.goOn : t.run.pace.pause}
      </Button>
      <PaceSteps motion={motion} speed={speed} />
    </section>
  );
}

/** Slower and faster, and how fast it is. */
export function PaceSteps({ motion, speed }: Omit<Props, "paused">) {
  const [slower, faster] = [nextPace(speed, false), nextPace(speed, true)];
  const slow = useAction(() => changePace(motion, { speed: slower }));
  const quicken = useAction(() => changePace(motion, { speed: faster }));
  const problem = slow.problem ?? quicken.problem;
  return (
    <>
      {problem && <ProblemNotice problem={problem} />}
      <p role="status">{t.run.pace.is(percent(speed))}</p>
      <div class="pace-steps">
        <Button why={slower === speed ? t.run.pace.slowest : null} onPress={slow.start}>
          {t.run.pace.slower}
        </Button>
        <Button why={faster === speed ? t.run.pace.fastest : null} onPress={quicken.start}>
          {t.run.pace.faster}
        </Button>
      </div>
    </>
  );
}
