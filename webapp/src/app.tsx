// The frame around every screen: robot state and sections on top, Stop at the bottom.
import { useEffect } from "preact/hooks";
import { ButtonLink } from "./components/button";
import { ControlStrip } from "./components/control-strip";
import { Icon, type IconName } from "./components/icon";
import { LoadNotice } from "./components/notice";
import { Page } from "./components/page";
import { RobotBar } from "./components/robot-bar";
import { StopBar } from "./components/stop-bar";
import { DashboardPage } from "./pages/dashboard/dashboard";
import { LanguagePage } from "./pages/language";
import { OfflinePage } from "./pages/offline";
import { PairingPage } from "./pages/pairing";
import { JoinPage } from "./pages/phones/join";
import { RobotsPage } from "./pages/robots";
import { MotionPage } from "./pages/run/motion";
import { PositionsPage } from "./pages/run/positions";
import { PreviewPage } from "./pages/run/preview";
import { QuestionsPage } from "./pages/run/questions";
import { RunPage } from "./pages/run/run";
import { SetupPage } from "./pages/run/setup";
import { ModelPage } from "./pages/teach/model";
import { MorePage } from "./pages/teach/more";
import { NewTaskPage } from "./pages/teach/new-task";
import { RecordPage } from "./pages/teach/record";
import { TakePage } from "./pages/teach/take";
import { TaskPage } from "./pages/teach/task";
import { TeachPage } from "./pages/teach/teach";
import { link, type Route } from "./router";
import { useLoad } from "./state/hooks";
import { showLastKnown, startLive } from "./state/live";
import { route, type Target } from "./state/navigation";
import { robotId } from "./state/robots";
import { beginSession, mustPair, session } from "./state/session";
import { t } from "./texts";

export function App() {
  const load = useLoad(beginSession, "session");
  const open = session.value !== null && !mustPair.value;
  const robot = robotId.value;
  const ready = open && robot !== "";
  useEffect(() => {
    if (ready) startLive(robot);
  }, [ready, robot]);
  // The server did not answer at all: what a phone knows by itself is better than nothing.
  const alone = session.value === null && load.problem?.code === "unreachable";
  useEffect(() => {
    if (alone) showLastKnown();
  }, [alone]);
  // A phone that is not paired yet is set up on this page.
  const joining = session.value !== null && route.value.page === "join";
  return (
    <div class="frame">
      <header>
        <RobotBar />
        {ready && <ControlStrip />}
        {ready && <Sections />}
      </header>
      {alone ? (
        <OfflinePage load={load} />
      ) : ready || route.value.page === "language" ? (
        <Screen route={route.value} />
      ) : joining ? (
        <JoinPage key="join" />
      ) : open ? (
        // The overview is of all robots, so none has to be chosen for it.
        route.value.page === "dashboard" ? (
          <DashboardPage />
        ) : (
          <RobotsPage />
        )
      ) : mustPair.value ? (
        <PairingPage problem={load.problem} />
      ) : (
        <Page title={t.app.name} first>
          <LoadNotice load={load} empty />
        </Page>
      )}
      <StopBar />
    </div>
  );
}

function Sections() {
  const run: ReadonlySet<Route["page"]> = new Set<Route["page"]>([
    "run",
    "setup",
    "positions",
    "preview",
    "motion",
    "questions",
  ]);
  const neither: ReadonlySet<Route["page"]> = new Set<Route["page"]>([
    "robots",
    "dashboard",
    "language",
  ]);
  const { page: shown } = route.value;
  const here = neither.has(shown) ? null : run.has(shown) ? "run" : "teach";
  const tab = (page: "teach" | "run", icon: IconName) => (
    <a href={link({ page } as Target)} aria-current={here === page ? "page" : undefined}>
      <Icon name={icon} />
      {t.app[page]}
    </a>
  );
  return (
    <nav class="sections" aria-label={t.app.sections}>
      {tab("teach", "teach")}
      {tab("run", "play")}
    </nav>
  );
}

/** Keys make a new screen of each address: nothing of another task's state is left over. */
function Screen({ route }: { route: Route }) {
  switch (route.page) {
    case "teach":
      return <TeachPage key="teach" />;
    case "new-task":
      return <NewTaskPage key="new-task" />;
    case "task":
      return <TaskPage key={`task ${route.task}`} task={route.task} />;
    case "more":
      return <MorePage key={`more ${route.task}`} task={route.task} />;
    case "record":
      return <RecordPage key={`record ${route.task}`} task={route.task} />;
    case "take":
      return <TakePage key={route.take} task={route.task} take={route.take} />;
    case "model":
      return <ModelPage key={route.model} task={route.task} model={route.model} />;
    case "robots":
      return <RobotsPage key="robots" />;
    case "dashboard":
      return <DashboardPage key="dashboard" />;
    case "language":
      return <LanguagePage key="language" />;
    case "join":
      return <JoinPage key="join" />;
    case "run":
      return <RunPage key="run" />;
    case "setup":
      return <SetupPage key={`setup ${route.task}`} task={route.task} />;
    case "preview":
      return <PreviewPage key={`preview ${route.task}`} task={route.task} />;
    case "motion":
      return <MotionPage key={route.motion} task={route.task} motion={route.motion} />;
    case "questions":
      return <QuestionsPage key={route.motion} task={route.task} motion={route.motion} />;
    case "positions":
      return <PositionsPage key={`positions ${route.task}`} task={route.task} />;
    case "missing":
      return (
        <Page
          key="missing"
          title={t.app.pageMissing}
          actions={
            <ButtonLink to={{ page: "teach" }} look="primary">
              {t.app.toTeach}
            </ButtonLink>
          }
        />
      );
  }
}
