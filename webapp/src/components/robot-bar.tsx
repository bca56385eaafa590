// The robot's state on top of every screen.
import { useComputed } from "@preact/signals";
import { connection, nowMs, robot, robotAtMs } from "../state/live";
import { robotStatus } from "../state/robot-status";
import { t } from "../texts";
import { Icon } from "./icon";

export function RobotBar() {
  // Compared as text: the bar is drawn again only when it says something else, not at each of
  // the many messages a second.
  const text = useComputed(() =>
    JSON.stringify(robotStatus(robot.value, connection.value, nowMs.value - robotAtMs.value)),
  );
  const status = JSON.parse(text.value) as ReturnType<typeof robotStatus>;
  return (
    <section class={`robot-bar tone-${status.tone}`} aria-label={t.robot.bar}>
      <Icon name={status.icon} />
      <strong role="status">{status.word}</strong>
      <span class="robot-age">{status.age}</span>
    </section>
  );
}
