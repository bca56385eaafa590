// Said on screens that show something under way, when the phone no longer hears of it.
import { connection } from "../state/live";
import { t } from "../texts";
import { Notice } from "./notice";

export function OfflineNotice() {
  if (connection.value === "live") return null;
  return (
    <Notice tone="soft" icon="unplugged" title={t.robot.offline}>
      <p>{t.robot.offlineWork}</p>
    </Notice>
  );
}
