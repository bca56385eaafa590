// A recording in progress: impossible to overlook, with the time and what is being recorded.
import { useRef } from "preact/hooks";
import { LiveArm } from "../../arm3d/live-arm";
import type { Demonstration } from "../../api/types";
import { OfflineNotice } from "../../components/offline-notice";
import { Icon } from "../../components/icon";
import { SignalButtons } from "../../components/signal-buttons";
import { duration } from "../../format/numbers";
import { LiveTraces } from "../../plots/live-traces";
import { connection, isVirtual, nowMs } from "../../state/live";
import { t } from "../../texts";

export function RecordingView({ take }: { take: Demonstration }) {
  if (take.state === "preparing") {
    return (
      <div class="recording recording-preparing" role="status">
        <p class="recording-state">
          <span class="spinner" aria-hidden="true" />
          <strong>{t.teach.states.preparing}</strong>
        </p>
        <p>{t.teach.preparing}</p>
      </div>
    );
  }
  const live = connection.value === "live";
  // Who leads by the picture needs the room for it.
  const byPicture = isVirtual.value && take.source === "hand_guiding";
  const look = `recording ${live ? "recording-on" : "recording-old"}`;
  return (
    <>
      <OfflineNotice />
      <div class={byPicture ? `${look} recording-slim` : look}>
        <p class="recording-state" role="status">
          <Icon name="record" />
          <strong>{t.teach.recordingNow}</strong>
        </p>
        <Elapsed take={take} />
        {!byPicture && <p>{take.source === "virtual_hand" ? t.teach.leadVirtual : t.teach.lead}</p>}
      </div>
      <LiveArm fill={byPicture} />
      <SignalButtons />
      <LiveTraces />
    </>
  );
}

/** The server's figure, carried on by this phone's clock until the next one comes. */
function Elapsed({ take }: { take: Demonstration }) {
  const last = useRef({ durationS: take.duration_s, atMs: Date.now() });
  if (last.current.durationS !== take.duration_s) {
    last.current = { durationS: take.duration_s, atMs: Date.now() };
  }
  // Offline the time stands still: nobody knows whether the recording goes on.
  const sinceMs = connection.value === "live" ? Math.max(0, nowMs.value - last.current.atMs) : 0;
  return (
    <p class="elapsed" role="timer" aria-label={t.teach.elapsed}>
      {duration(last.current.durationS + sinceMs / 1000)}
    </p>
  );
}
