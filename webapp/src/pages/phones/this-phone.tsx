// What this phone itself is set to: the app on its home screen, and sounds.
import { Button } from "../../components/button";
import { Icon } from "../../components/icon";
import { install, installOffer, isInstalled, platform } from "../../state/install";
import { give, mute, muted } from "../../state/signals-to-hand";
import { t } from "../../texts";

export function ThisPhone() {
  const iphone = platform(navigator.userAgent, navigator.maxTouchPoints) === "iphone";
  const hint = window.isSecureContext && iphone && !isInstalled();
  return (
    <section class="card" aria-labelledby="this-phone">
      <h2 id="this-phone">{t.phones.thisPhone}</h2>
      <p>{window.isSecureContext ? t.phones.secured : t.phones.insecureMeans}</p>
      {isInstalled() && <p>{t.phones.installed}</p>}
      {installOffer.value && (
        <Button icon="download" onPress={() => void install()}>
          {t.phones.install}
        </Button>
      )}
      {hint && <p>{t.phones.installIphone}</p>}
      <p class={`state tone-${muted.value ? "stale" : "good"}`} role="status">
        <Icon name={muted.value ? "cross" : "check"} />
        {muted.value ? t.phones.soundsOff : t.phones.soundsOn}
      </p>
      <Button onPress={switchSounds}>{muted.value ? t.phones.switchOn : t.phones.switchOff}</Button>
    </section>
  );
}

function switchSounds(): void {
  mute(!muted.peek());
  give("tick");
}
