// An entry of a list that leads to its own screen.
import type { ComponentChildren } from "preact";
import { link } from "../router";
import type { Target } from "../state/navigation";
import { Icon } from "./icon";

interface Props {
  to: Target;
  label: string;
  children: ComponentChildren;
}

export function RowLink({ to, label, children }: Props) {
  return (
    <li>
      <a class="row" href={link(to)} aria-label={label}>
        {children}
        <Icon name="next" />
      </a>
    </li>
  );
}
