// A take on its way: to be held up, to go on, to be ended.
import { closeDemonstration, pauseRecording, resumeRecording } from "../../api/endpoints";
import type { Demonstration } from "../../api/types";
import { Button } from "../../components/button";
import { ProblemNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { demonstrations } from "../../state/entities";
import { useAction } from "../../state/hooks";
import { useWakeLock } from "../../state/wake-lock";
import { t } from "../../texts";
import { PausedView, usePlace } from "./paused-view";
import { RecordingView } from "./recording-view";

export function OpenTake({ take }: { take: Demonstration }) {
  useWakeLock(true);
  const stop = useAction(async () => demonstrations.put(await closeDemonstration(take.id, "stop")));
  const pause = useAction(async () => demonstrations.put(await pauseRecording(take.id)));
  const resume = useAction(async () => demonstrations.put(await resumeRecording(take.id)));
  const paused = Boolean(take.paused_at_deg);
  const place = usePlace(take);
  const problem = stop.problem ?? pause.problem ?? resume.problem;
  return (
    <Page
      title={t.teach.take(take.take)}
      actions={
        <>
          {take.state === "recording" && !paused && (
            <Button
              icon="pause"
              why={take.source === "virtual_hand" ? t.teaching.pause.notHand : null}
              busy={pause.busy && t.teaching.pause.pausing}
              onPress={pause.start}
            >
              {t.teaching.pause.press}
            </Button>
          )}
          <Button
            look={paused ? "secondary" : "primary"}
            icon="check"
            busy={stop.busy && t.teach.stoppingRecording}
            onPress={stop.start}
          >
            {take.state === "preparing" ? t.app.cancel : t.teach.stopRecording}
          </Button>
          {paused && (
            <Button
              look="primary"
              icon="play"
              why={place?.isHere ? null : t.teaching.pause.notHere}
              busy={resume.busy && t.teaching.pause.goingOn}
              onPress={resume.start}
            >
              {t.teaching.pause.goOn}
            </Button>
          )}
        </>
      }
    >
      {problem && <ProblemNotice problem={problem} />}
      {paused ? <PausedView take={take} place={place} /> : <RecordingView take={take} />}
    </Page>
  );
}
