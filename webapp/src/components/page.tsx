// The inside of every screen: title with the way back, content, and the actions at the bottom.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { link } from "../router";
import type { Target } from "../state/navigation";
import { t } from "../texts";
import { FaultNotice } from "./fault-notice";
import { Icon } from "./icon";
import { LanguageLink } from "./language-link";
import { UpdateNotice } from "./update-notice";

interface Props {
  title: string;
  back?: Target;
  /** One of the first screens a person sees: their language can be chosen here. */
  first?: boolean;
  actions?: ComponentChildren;
  children?: ComponentChildren;
}

export function Page({ title, back, first, actions, children }: Props) {
  const heading = useRef<HTMLHeadingElement>(null);
  // A new screen starts at its title, for screen readers and keyboards too.
  useEffect(() => {
    heading.current?.focus({ preventScroll: true });
    // Where the screen is low the window scrolls, and would stay where the screen before was left.
    window.scrollTo(0, 0);
  }, []);
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
          {first && <LanguageLink />}
        </div>
        {children}
      </main>
      {actions && (
        <section class="actions" aria-label={title}>
          {actions}
        </section>
      )}
    </>
  );
}
