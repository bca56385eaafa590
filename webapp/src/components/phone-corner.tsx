// At the end of the first page: what this phone lacks, said once, and the way to set it up.
import { useSignal } from "@preact/signals";
import { recall, remember } from "../state/browser-store";
import { session } from "../state/session";
import { t } from "../texts";
import { Button, ButtonLink } from "./button";
import { Notice } from "./notice";

const DISMISSED = "team.insecure-known";

export function PhoneCorner() {
  return (
    <>
      <InsecureNotice />
      <ButtonLink to={{ page: "join" }} look="quiet" icon="plus">
        {t.phones.open}
      </ButtonLink>
    </>
  );
}

function InsecureNotice() {
  const known = useSignal(recall(DISMISSED) === "yes");
  if (window.isSecureContext || known.value) return null;
  const dismiss = () => {
    remember(DISMISSED, "yes");
    known.value = true;
  };
  return (
    <Notice tone="plain" icon="info" title={t.phones.insecure}>
      <p>{t.phones.insecureMeans}</p>
      <div class="notice-actions">
        {session.value?.https ? (
          <ButtonLink to={{ page: "join" }} icon="next">
            {t.phones.setUp}
          </ButtonLink>
        ) : (
          <p>{t.phones.insecureAsk}</p>
        )}
        <Button look="quiet" icon="check" onPress={dismiss}>
          {t.phones.dismiss}
        </Button>
      </div>
    </Notice>
  );
}
