// An entry of a list that leads to its own screen.
import type { ComponentChildren } from "preact";
import { link } from "../router";
import type { Target } from "../state/navigation";
import { Icon } from "./icon";

interface Props {
  to: Target;
  /** Its name where the words on it do not suffice. It contains all of them in their order, so
   *  that people who speak to the phone can say what they see; spaces stand between the words. */
  label?: string;
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
