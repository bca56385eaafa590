// The app on a phone that does not reach the server: what it knew last, how old that is, and why
// nothing can be started. There is nothing here that would be sent later.
import { useEffect } from "preact/hooks";
import { Button } from "../components/button";
import { Figures } from "../components/figures";
import { Notice } from "../components/notice";
import { Page } from "../components/page";
import { age, degrees } from "../format/numbers";
import type { Load } from "../state/hooks";
import { nowMs, robot, robotAtMs } from "../state/live";
import { language, t } from "../texts";

/** How often the server is looked for. */
const EVERY_MS = 3000;

export function OfflinePage({ load }: { load: Load }) {
  useEffect(() => {
    const timer = setInterval(load.again, EVERY_MS);
    window.addEventListener("online", load.again);
    return () => {
      clearInterval(timer);
      window.removeEventListener("online", load.again);
    };
  }, [load.again]);
  return (
    <Page
      title={t.phones.offlineTitle}
      actions={
        <Button look="primary" icon="again" onPress={load.again}>
          {t.phones.reconnect}
        </Button>
      }
    >
      <Notice tone="soft" icon="unplugged" title={t.phones.offlineWhat}>
        <p>{t.phones.offlineWait}</p>
      </Notice>
      <LastKnown />
      <Button icon="record" why={t.robot.why.offline} onPress={() => undefined}>
        {t.app.teach}
      </Button>
      <Button icon="play" why={t.robot.why.offline} onPress={() => undefined}>
        {t.app.run}
      </Button>
    </Page>
  );
}

function LastKnown() {
  const view = robot.value;
  if (view === null) return null;
  const heardAt = new Date(robotAtMs.value).toLocaleString(language, {
    dateStyle: "medium",
    timeStyle: "short",
  });
  const joints = (view.joints_deg ?? []).map(
    (joint, index) => [t.plot.joint(index + 1), degrees(joint)] as const,
  );
  return (
    <section class="card" aria-labelledby="last-known">
      <h2 id="last-known">{t.phones.lastKnown}</h2>
      <Figures
        list={[
          [t.phones.robot, view.name],
          [
            t.phones.state,
            t.robot.ago(t.robot.states[view.state], age(nowMs.value - robotAtMs.value)),
          ],
          [t.phones.heardAt, heardAt],
          ...joints,
        ]}
      />
    </section>
  );
}
