// The Stop that is on every screen. It acts on the first touch, not on the release, and says
// whether it got through.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { stop } from "../state/live";
import { t } from "../texts";
import { Icon } from "./icon";

/** How long the word that it got through stays. That it did not stays until the next press. */
const WORD_MS = 4000;
/** Without an answer for this long the person must be told to use another way to stop. */
const PATIENCE_MS = 1500;

type Sent = "no" | "sending" | "sent" | "failed";

export function StopBar() {
  const sent = useSignal<Sent>("no");
  const press = () => {
    sent.value = "sending";
    stop().then(
      () => (sent.value = "sent"),
      () => (sent.value = "failed"),
    );
  };
  useEffect(() => {
    const next = { no: null, failed: null, sending: "failed", sent: "no" } as const;
    const then = next[sent.value];
    if (then === null) return;
    const wait = sent.value === "sent" ? WORD_MS : PATIENCE_MS;
    const timer = setTimeout(() => (sent.value = then), wait);
    return () => clearTimeout(timer);
  }, [sent.value]);
  const words = { no: "", sending: t.stop.sending, sent: t.stop.sent, failed: t.stop.failed };
  return (
    <div class="stop-bar">
      <button
        type="button"
        class="stop"
        onPointerDown={press}
        onClick={(event) => {
          // Without pointer (keyboard, switch control) only the click comes.
          if (event.detail === 0) press();
        }}
      >
        <Icon name="stop" />
        <span>{t.stop.button}</span>
      </button>
      <p class={sent.value === "failed" ? "stop-words stop-failed" : "stop-words"} role="status">
        {words[sent.value]}
      </p>
    </div>
  );
}
