// Phones: how another one comes in, and what this one still needs. Also the first page of a phone
// that was led here by the QR code of a server with HTTPS.
import { useSignal } from "@preact/signals";
import { getJoining, joiningPicture } from "../../api/endpoints";
import type { Joining } from "../../api/types";
import { ButtonLink } from "../../components/button";
import { Figures } from "../../components/figures";
import { LoadNotice } from "../../components/notice";
import { Page } from "../../components/page";
import { useLoad } from "../../state/hooks";
import { mustPair, session } from "../../state/session";
import { t } from "../../texts";
import { CertificateGuide, CertificateActions } from "./certificate";
import { ThisPhone } from "./this-phone";

export function JoinPage() {
  const guided = !window.isSecureContext && session.value?.https === true;
  return (
    <Page
      title={guided ? t.phones.setUp : t.phones.title}
      {...(mustPair.value ? {} : { back: { page: "teach" } as const })}
      actions={
        guided ? (
          <CertificateActions />
        ) : (
          mustPair.value && (
            <ButtonLink to={{ page: "teach" }} look="primary" icon="next">
              {t.pairing.title}
            </ButtonLink>
          )
        )
      }
    >
      {guided && <CertificateGuide />}
      {!mustPair.value && <AnotherPhone />}
      <ThisPhone />
    </Page>
  );
}

function AnotherPhone() {
  const joining = useSignal<Joining | null>(null);
  const load = useLoad(async () => {
    joining.value = await getJoining();
  }, "join");
  const known = joining.value;
  return (
    <section class="card" aria-labelledby="add-phone">
      <h2 id="add-phone">{t.phones.add}</h2>
      <LoadNotice load={load} empty={known === null} />
      {known && !known.address && <p>{t.phones.onlyHere}</p>}
      {known?.address && (
        <>
          <p>{t.phones.addHow}</p>
          <img class="joining" src={joiningPicture} alt={t.phones.picture} />
          <Figures
            list={[
              [t.phones.address, known.address],
              [t.phones.code, known.code ? spaced(known.code) : null],
            ]}
          />
          {known.certificate_sha256 && (
            <details>
              <summary>{t.phones.fingerprint}</summary>
              <p class="fingerprint">{known.certificate_sha256}</p>
            </details>
          )}
        </>
      )}
    </section>
  );
}

function spaced(code: string): string {
  return `${code.slice(0, 4)} ${code.slice(4)}`;
}
