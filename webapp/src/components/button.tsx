// Buttons and links that look like them: big, with a visible pressed state, and never silent
// about why they cannot be pressed or what they are doing.
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { link } from "../router";
import type { Target } from "../state/navigation";
import { Icon, type IconName } from "./icon";

export type Look = "primary" | "secondary" | "danger" | "quiet";

interface Props {
  look?: Look;
  icon?: IconName;
  /** What it says while it works; the button cannot be pressed a second time meanwhile. */
  busy?: string | null | false;
  /** Why it cannot be pressed now; also shown. */
  why?: string | null;
  onPress: () => void;
  children: ComponentChildren;
}

export function Button({ look = "secondary", icon, busy, why, onPress, children }: Props) {
  const id = useId();
  const blocked = Boolean(why);
  return (
    <div class="button-box">
      {blocked && (
        <p class="why" id={id}>
          {why}
        </p>
      )}
      <button
        type="button"
        class={`button button-${look}`}
        disabled={blocked || Boolean(busy)}
        aria-describedby={blocked ? id : undefined}
        aria-busy={Boolean(busy)}
        onClick={onPress}
      >
        {busy ? <span class="spinner" aria-hidden="true" /> : icon && <Icon name={icon} />}
        <span>{busy || children}</span>
      </button>
    </div>
  );
}

interface LinkProps {
  to: Target;
  look?: Look;
  icon?: IconName;
  label?: string;
  children: ComponentChildren;
}

export function ButtonLink({ to, look = "secondary", icon, label, children }: LinkProps) {
  return (
    <a class={`button button-${look}`} href={link(to)} aria-label={label}>
      {icon && <Icon name={icon} />}
      <span>{children}</span>
    </a>
  );
}
