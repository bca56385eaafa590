// The robots of the cell: choosing the one that this phone works with, and how each of them is.
import { useEffect } from "preact/hooks";
import type { RobotView } from "../api/types";
import { ButtonLink } from "../components/button";
import { Icon } from "../components/icon";
import { LoadNotice } from "../components/notice";
import { Page } from "../components/page";
import { age } from "../format/numbers";
import { useLoad } from "../state/hooks";
import { go } from "../state/navigation";
import { robotStatus, STALE_AFTER_MS } from "../state/robot-status";
import { chooseRobot, loadRobots, robotId, robots } from "../state/robots";
import { t } from "../texts";

/** How often the list is asked for while it is on the screen. */
const EVERY_MS = 1500;

export function RobotsPage() {
  const load = useLoad(loadRobots, "robots");
  useEffect(() => {
    const timer = setInterval(load.again, EVERY_MS);
    return () => clearInterval(timer);
  }, [load.again]);
  const list = robots.value;
  return (
    <Page title={t.robots.title} first>
      {load.problem && <LoadNotice load={load} empty={list.length === 0} />}
      <p>{robotId.value === "" ? t.robots.chooseFirst : t.robots.choose}</p>
      <ul class="rows">
        {list.map((one) => (
          <li key={one.id}>
            <RobotRow robot={one} />
          </li>
        ))}
      </ul>
      <ButtonLink to={{ page: "dashboard" }} look="quiet" icon="train">
        {t.dashboard.open}
      </ButtonLink>
    </Page>
  );
}

function RobotRow({ robot }: { robot: RobotView }) {
  const status = robotStatus(robot, "live", 0);
  const choose = () => {
    chooseRobot(robot.id);
    go({ page: "teach" });
  };
  return (
    <button
      type="button"
      class="row robot-row"
      aria-pressed={robot.id === robotId.value}
      onClick={choose}
    >
      <span class="row-name">
        <strong>{robot.name}</strong>
        <span class={`state tone-${status.tone}`}>
          <Icon name={status.icon} />
          {status.word}
        </span>
        {robot.fault && <span>{robot.fault.message}</span>}
        <span>{joints(robot)}</span>
        <span>{control(robot)}</span>
      </span>
      {robot.id === robotId.value && <Icon name="check" />}
    </button>
  );
}

function joints(robot: RobotView): string {
  if (!robot.joints_deg) return t.robots.noJoints;
  return robot.age_ms < STALE_AFTER_MS ? t.robots.jointsNow : t.robots.jointsAge(age(robot.age_ms));
}

function control({ egm }: RobotView): string {
  if (egm.cycles === 0) return t.robots.egmNever;
  const link = egm.connected ? t.robots.egmOn : t.robots.egmOff;
  const priority = egm.real_time ? t.robots.priority : t.robots.noPriority;
  return t.robots.egm(link, egm.lost, egm.late, priority);
}
