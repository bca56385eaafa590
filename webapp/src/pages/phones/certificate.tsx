// The way to the cell's certificate, step by step for each kind of phone, and on to HTTPS.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { Button } from "../../components/button";
import { Choice } from "../../components/choice";
import { Icon } from "../../components/icon";
import { Notice } from "../../components/notice";
import { platform, type Platform } from "../../state/install";
import { certificateFile, lookForCertificate, onwards, trusted } from "../../state/joining";
import { t } from "../../texts";

/** How often is looked while the page is open: people come back from the settings. */
const EVERY_MS = 2000;
const PLATFORMS: readonly Platform[] = ["iphone", "android", "other"];

export function CertificateGuide() {
  const kind = useSignal(platform(navigator.userAgent, navigator.maxTouchPoints));
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    let open = true;
    const look = async () => {
      await lookForCertificate();
      if (open && !trusted.peek()) timer = setTimeout(look, EVERY_MS);
    };
    void look();
    return () => {
      open = false;
      clearTimeout(timer);
    };
  }, []);
  if (trusted.value) return <Notice tone="good" icon="check" title={t.phones.trusted} />;
  return (
    <>
      <p>{t.phones.setUpWhy}</p>
      <Choice
        legend={t.phones.whichPhone}
        options={PLATFORMS.map((value) => ({ value, name: t.phones.platforms[value] }))}
        value={kind.value}
        onChoose={(value) => (kind.value = value)}
        row
      />
      <ol class="steps">
        {t.phones.steps[kind.value].map((step) => (
          <li key={step}>{step}</li>
        ))}
      </ol>
      <p role="status">{trusted.value === null ? t.phones.looking : t.phones.notTrusted}</p>
      <p>{t.phones.goOnMeans}</p>
    </>
  );
}

export function CertificateActions() {
  const leave = (secured: boolean) => {
    location.href = onwards(secured);
    // Without HTTPS only the part behind the # is another one, and the code is read at the start.
    if (!secured) location.reload();
  };
  if (trusted.value) {
    return (
      <Button look="primary" icon="next" onPress={() => leave(true)}>
        {t.phones.openSecured}
      </Button>
    );
  }
  return (
    <>
      <Button icon="next" onPress={() => leave(false)}>
        {t.phones.goOn}
      </Button>
      <a class="button button-primary" href={certificateFile}>
        <Icon name="download" />
        <span>{t.phones.certificate}</span>
      </a>
    </>
  );
}
