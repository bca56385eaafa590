// The robot's state on top of every screen; with several robots also its name and the way to the
// others.
import { useComputed } from "@preact/signals";
import { link } from "../router";
import { connection, nowMs, robot, robotAtMs } from "../state/live";
import { robotStatus } from "../state/robot-status";
import { robotId, robots } from "../state/robots";
import { t } from "../texts";
import { Icon } from "./icon";

export function RobotBar() {
  // Compared as text: the bar is drawn again only when it says something else, not at each of
  // the many messages a second.
  const text = useComputed(() =>
    JSON.stringify(robotStatus(robot.value, connection.value, nowMs.value - robotAtMs.value)),
  );
  const status = JSON.parse(text.value) as ReturnType<typeof robotStatus>;
  const several = robots.value.length > 1;
  const name = robots.value.find((one) => one.id === robotId.value)?.name;
  if (several && name === undefined) return null;
  return (
    <section class={`robot-bar tone-${status.tone}`} aria-label={t.robot.bar}>
      <Icon name={status.icon} />
      <strong role="status">{status.word}</strong>
      <span class="robot-age">{status.age}</span>
      {several && name !== undefined && (
        <a class="robot-name" href={link({ page: "robots" })} aria-label={t.robots.change(name)}>
          <span>{name}</span>
          <Icon name="next" />
        </a>
      )}
    </section>
  );
}
