// The button that is held while the arm moves. It is let go by lifting the finger anywhere, and by
// everything else that may take the finger or the phone away.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../../components/icon";
import { beginHolding } from "../../state/holding";
import { t } from "../../texts";

export function HoldButton({ motion }: { motion: string }) {
  const held = useSignal(false);
  const end = useRef<() => void>(() => undefined);
  const press = () => {
    if (held.peek()) return;
    held.value = true;
    end.current = beginHolding(motion, () => (held.value = false));
  };
  const release = () => end.current();
  useEffect(() => () => end.current(), []);
  return (
    <button
      type="button"
      class={held.value ? "hold hold-on" : "hold"}
      aria-pressed={held.value}
      aria-description={t.hold.keys}
      onPointerDown={(event) => {
        // The finger may slide off the button without letting go of the arm by accident.
        event.currentTarget.setPointerCapture(event.pointerId);
        press();
      }}
      onPointerUp={release}
      onPointerCancel={release}
      onLostPointerCapture={release}
      onBlur={release}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if ((event.key === " " || event.key === "Enter") && !event.repeat) press();
        if (event.key === " " || event.key === "Enter") event.preventDefault();
      }}
      onKeyUp={release}
    >
      <Icon name={held.value ? "move" : "hand"} />
      <span>{held.value ? t.hold.holding : t.hold.button}</span>
    </button>
  );
}
