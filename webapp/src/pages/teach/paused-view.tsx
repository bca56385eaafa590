// A recording that is held up: unmistakably not recording, and how far the arm is from the place.
import { useComputed } from "@preact/signals";
import type { Demonstration } from "../../api/types";
import { Icon } from "../../components/icon";
import { Notice } from "../../components/notice";
import { OfflineNotice } from "../../components/offline-notice";
import { SignalButtons } from "../../components/signal-buttons";
import { degrees, duration } from "../../format/numbers";
import { connection, robot } from "../../state/live";
import { t } from "../../texts";

/** As the server has it: further off it does not go on. */
const NEAR_DEG = 2;

export interface Place {
  joint: number;
  offDeg: number;
  isHere: boolean;
}

/** The joint that is furthest from where it was; null when one of the two is not known. */
export function furthest(
  from: readonly number[] | null | undefined,
  to: readonly number[] | null | undefined,
): Place | null {
  if (!from || !to) return null;
  const off = from.map((angle, joint) => Math.abs(angle - (to[joint] ?? angle)));
  const offDeg = Math.max(0, ...off);
  return { joint: off.indexOf(offDeg) + 1, offDeg, isHere: offDeg <= NEAR_DEG };
}

/** Where the arm is beside where the recording was held up, as it moves. */
export function usePlace(take: Demonstration): Place | null {
  // As text: drawn again only when it says something else. Rounded up, so that nobody is told of
  // 2.0° and that it is too far.
  const text = useComputed(() => {
    const joints = connection.value === "live" ? robot.value?.joints_deg : null;
    const place = furthest(take.paused_at_deg, joints);
    return JSON.stringify(place && { ...place, offDeg: Math.ceil(place.offDeg * 10) / 10 });
  });
  return JSON.parse(text.value) as Place | null;
}

export function PausedView({ take, place }: { take: Demonstration; place: Place | null }) {
  return (
    <>
      <OfflineNotice />
      <div class="recording recording-paused">
        <p class="recording-state" role="status">
          <Icon name="pause" />
          <strong>{t.teaching.pause.paused}</strong>
          <span role="timer" aria-label={t.teach.elapsed}>
            {duration(take.duration_s)}
          </span>
        </p>
        <p>{t.teaching.pause.explain}</p>
      </div>
      <div role="status">
        <PlaceNotice place={place} />
      </div>
      <SignalButtons />
    </>
  );
}

function PlaceNotice({ place }: { place: Place | null }) {
  if (!place) {
    return (
      <Notice tone="plain" icon="info">
        <p>{t.teaching.pause.unknown}</p>
      </Notice>
    );
  }
  return place.isHere ? (
    <Notice tone="good" icon="check">
      <p class="advice">{t.teaching.pause.here}</p>
    </Notice>
  ) : (
    <Notice tone="soft" icon="hand">
      <p class="advice">{t.teaching.pause.off(place.joint, degrees(place.offDeg))}</p>
    </Notice>
  );
}
