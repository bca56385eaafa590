// A newer build of the app is on this phone. The person says when; nothing is loaded anew by itself.
import { updateWaits, loadNewBuild } from "../state/app-version";
import { robotState } from "../state/live";
import { t } from "../texts";
import { Button } from "./button";
import { Notice } from "./notice";

export function UpdateNotice() {
  // While the arm is moved by anyone, there are more important things on the screen.
  const underWay = ["guiding", "reproducing", "stopping"].includes(robotState.value ?? "");
  if (!updateWaits.value || underWay) return null;
  return (
    <Notice tone="plain" icon="info" title={t.phones.update}>
      <p>{t.phones.updateWhen}</p>
      <Button icon="again" onPress={loadNewBuild}>
        {t.phones.reload}
      </Button>
    </Notice>
  );
}
