// Every request the app makes, one line each.
import { address, request } from "./client";
import type {
  Curve,
  Dashboard,
  Demonstration,
  Flight,
  FlightEvent,
  Grouping,
  HandScript,
  Job,
  Joining,
  Model,
  Plan,
  PlanRequest,
  Position,
  QuestionnaireDue,
  QuestionnaireResult,
  ReplyRequest,
  Reproduction,
  RobotView,
  Session,
  Task,
  TaskAgreement,
  Trajectory,
  Trim,
  TrimSuggestion,
} from "./types";

export const getSession = () => request<Session>("GET", "/session");
export const pair = (code: string) => request<null>("POST", "/session", { body: { code } });

export const getJoining = () => request<Joining>("GET", "/join");
/** For a picture: the same as a QR code. */
export const joiningPicture = address("/join.svg");

export const listTasks = () => request<Task[]>("GET", "/tasks");
export const getTask = (task: string) => request<Task>("GET", `/tasks/${task}`);
export const createTask = (id: string, name: string) =>
  request<Task>("POST", "/tasks", { body: { id, name } });
export const renameTask = (task: string, name: string) =>
  request<Task>("PATCH", `/tasks/${task}`, { body: { name } });
export const deleteTask = (task: string) => request<null>("DELETE", `/tasks/${task}`);
export const restoreTask = (task: string) => request<Task>("POST", `/tasks/${task}/restore`);
export const putPicture = (task: string, file: Blob) =>
  request<Task>("PUT", `/tasks/${task}/picture`, { file });
export const deletePicture = (task: string) => request<Task>("DELETE", `/tasks/${task}/picture`);
/** For the browser, which keeps it: `picture` is another name for each photo. */
export const pictureAddress = (task: string, picture: string) =>
  address(`/tasks/${task}/picture?v=${picture}`);

export interface NewDemonstration {
  id: string;
  robot: string;
  virtual_hand?: HandScript;
  seed?: number;
}
export const listDemonstrations = (task: string) =>
  request<Demonstration[]>("GET", `/tasks/${task}/demonstrations`);
export const getDemonstration = (id: string) =>
  request<Demonstration>("GET", `/demonstrations/${id}`);
export const startDemonstration = (task: string, body: NewDemonstration) =>
  request<Demonstration>("POST", `/tasks/${task}/demonstrations`, { body });
export const uploadDemonstration = (task: string, file: File) =>
  request<Demonstration>(
    "POST",
    `/tasks/${task}/demonstrations/upload?name=${encodeURIComponent(file.name)}`,
    { file },
  );
export const closeDemonstration = (id: string, action: "stop" | "keep" | "discard") =>
  request<Demonstration>("POST", `/demonstrations/${id}/${action}`);
export const undecide = (id: string) =>
  request<Demonstration>("POST", `/demonstrations/${id}/undecide`);
export const pauseRecording = (id: string) =>
  request<Demonstration>("POST", `/demonstrations/${id}/pause`);
export const resumeRecording = (id: string) =>
  request<Demonstration>("POST", `/demonstrations/${id}/resume`);
export const putTrim = (id: string, trim: Trim) =>
  request<Demonstration>("PUT", `/demonstrations/${id}/trim`, { body: trim });
export const deleteTrim = (id: string) =>
  request<Demonstration>("DELETE", `/demonstrations/${id}/trim`);
export const suggestTrim = (id: string) =>
  request<TrimSuggestion>("GET", `/demonstrations/${id}/trim/suggestion`);
/** Also what was cut away. */
export const getWholeTrajectory = (id: string, points: number) =>
  request<Trajectory>("GET", `/demonstrations/${id}/trajectory?raw=true&max_points=${points}`);
export const getTrajectory = (id: string, points: number) =>
  request<Trajectory>("GET", `/demonstrations/${id}/trajectory?max_points=${points}`);

export const getAgreement = (task: string) =>
  request<TaskAgreement>("GET", `/tasks/${task}/agreement`);

export const listModels = (task: string) => request<Model[]>("GET", `/tasks/${task}/models`);
export const getModel = (id: string) => request<Model>("GET", `/models/${id}`);
export const trainModel = (task: string) =>
  request<{ job: Job; model: Model }>("POST", `/tasks/${task}/models`, { body: {} });
export const getCurve = (id: string, points: number) =>
  request<Curve>("GET", `/models/${id}/curve?max_points=${points}`);
export const getJob = (id: string) => request<Job>("GET", `/jobs/${id}`);
export const cancelJob = (id: string) => request<Job>("POST", `/jobs/${id}/cancel`);

export const listRobots = () => request<RobotView[]>("GET", "/robots");
export const stopAllRobots = () => request<null>("POST", "/robots/stop", { keepalive: true });
export const stopRobot = (robot: string) =>
  request<null>("POST", `/robots/${robot}/stop`, { keepalive: true });
export const resetRobot = (robot: string) => request<unknown>("POST", `/robots/${robot}/reset`);
export const setLeadThrough = (robot: string, active: boolean) =>
  request<unknown>("POST", `/robots/${robot}/lead-through`, { body: { active } });
export const returnVirtualHand = (robot: string, script: HandScript, seed: number) =>
  request<unknown>("POST", `/robots/${robot}/virtual-hand`, {
    body: { action: "return", script, seed },
  });
export const changeControl = (robot: string, action: "ask" | "give" | "keep" | "release") =>
  request<unknown>("POST", `/robots/${robot}/control`, { body: { action } });
/** `signal` is the name as it stands in an address. */
export const setSignal = (robot: string, signal: string, on: boolean) =>
  request<unknown>("POST", `/robots/${robot}/signals/${signal}`, { body: { on } });

export const makePlan = (body: PlanRequest) => request<Plan>("POST", "/plans", { body });
/** `hold`: the arm moves only while somebody holds the button, said over the live socket. */
export const startReproduction = (id: string, robot: string, plan: string, hold: boolean) =>
  request<Reproduction>("POST", "/reproductions", { body: { id, robot, plan, hold } });
export const changePace = (id: string, pace: { speed?: number; paused?: boolean }) =>
  request<null>("POST", `/reproductions/${id}/pace`, { body: pace }).then(() => undefined);
export const planWayBack = (id: string) => request<Plan>("POST", `/reproductions/${id}/back`);
export const getReproduction = (id: string) => request<Reproduction>("GET", `/reproductions/${id}`);
export const getFlight = (id: string, points: number) =>
  request<Flight>("GET", `/reproductions/${id}/flight?points=${points}`);
export const getFlightEvents = (id: string) =>
  request<FlightEvent[]>("GET", `/reproductions/${id}/events`);
/** For a link: the browser saves the file as it comes. */
export const flightFile = (id: string, kind: "csv" | "mcap") =>
  address(`/reproductions/${id}/flight.${kind}`);

export const listReproductions = (task: string, limit: number) =>
  request<Reproduction[]>("GET", `/reproductions?task=${task}&limit=${limit}`);
export const setOutcome = (id: string, worked: boolean, note?: string) =>
  request<Reproduction>("PUT", `/reproductions/${id}/outcome`, { body: { worked, note } });
export const takeBackOutcome = (id: string) =>
  request<Reproduction>("DELETE", `/reproductions/${id}/outcome`);

export const listPositions = (robot: string) =>
  request<Position[]>("GET", `/positions?robot=${robot}`);
/** Where the arm stands now, as the server knows it. */
export const savePresentPosition = (id: string, robot: string, name: string) =>
  request<Position>("POST", "/positions", { body: { id, robot, name } });
export const changePosition = (id: string, change: { name?: string; present?: boolean }) =>
  request<Position>("PATCH", `/positions/${id}`, { body: change });
export const deletePosition = (id: string) => request<null>("DELETE", `/positions/${id}`);

export const questionnaireDue = (person: string, reproduction: string) =>
  request<QuestionnaireDue>(
    "GET",
    `/questionnaire/due?person=${person}&reproduction=${reproduction}`,
  );
export const sendReply = (body: ReplyRequest) =>
  request<unknown>("POST", "/questionnaire", { body });
export const questionnaireResults = (by: Grouping) =>
  request<QuestionnaireResult[]>("GET", `/questionnaire/results?by=${by}`);
export const getDashboard = () => request<Dashboard>("GET", "/dashboard");
