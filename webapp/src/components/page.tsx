// The inside of every screen: title with the way back, content, and the actions at the bottom.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { link } from "../router";
import type { Target } from "../state/navigation";
import { t } from "../texts";
import { FaultNotice } from "./fault-notice";
import { Icon } from "./icon";
import { UpdateNotice } from "./update-notice";

interface Props {
  title: string;
  back?: Target;
  actions?: ComponentChildren;
  children?: ComponentChildren;
}

export function Page({ title, back, actions, children }: Props) {
  const heading = useRef<HTMLHeadingElement>(null);
  // A new screen starts at its title, for screen readers and keyboards too.
  useEffect(() => heading.current?.focus({ preventScroll: true }), []);
  return (
    <>
      <main class="page">
        <FaultNotice />
        <UpdateNotice />
        <div class="page-head">
          {back && (
            <a class="back" href={link(back)} aria-label={t.app.back}>
              <Icon name="back" />
            </a>
          )}
          <h1 ref={heading} tabIndex={-1}>
            {title}
          </h1>
        </div>
        {children}
      </main>
      <div class="actions">{actions}</div>
    </>
  );
}
