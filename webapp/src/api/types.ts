// The shapes of the REST interface and of the live socket, in one place and named as the server's
// OpenAPI file names them. Angles in degrees, positions in millimetres, times in seconds.

export type Joints = number[];

export interface Session {
  paired: boolean;
  pairing_required: boolean;
  https: boolean;
  version: string;
}

/** What another phone needs to come in. */
export interface Joining {
  address?: string | null;
  code?: string | null;
  certificate_sha256?: string | null;
}

export interface Task {
  id: string;
  name: string;
  created_at: string;
  /** Names its photo; another photo has another name. */
  picture?: string | null;
}

/** The stretch of a take that is used, in seconds since its recording began. */
export interface Trim {
  from_s: number;
  to_s: number;
}

export interface TrimSuggestion {
  trim?: Trim | null;
}

export type DemonstrationState =
  "preparing" | "recording" | "recorded" | "kept" | "discarded" | "interrupted";

export type HandScript = "f1" | "f2" | "f3";

export interface Demonstration {
  id: string;
  task_id: string;
  take: number;
  state: DemonstrationState;
  source: "hand_guiding" | "virtual_hand" | "file";
  robot?: string | null;
  created_at: string;
  duration_s: number;
  samples: number;
  rate_hz: number;
  gaps: number;
  pauses?: number;
  /** Where the arm was when the recording was held up; only while it is. */
  paused_at_deg?: Joints | null;
  trim?: Trim | null;
  note?: string | null;
  usable: boolean;
  problem?: string | null;
}

/** Where a take differs most from the others. */
export interface WorstPlace {
  /** Share of the motion's time, 0 to 1. */
  phase: number;
  joint: number;
  off_deg: number;
}

export type Verdict = "agrees" | "differs" | "other_motion" | "unusable" | "open";

/** One take beside the others. */
export interface ComparedTake {
  id: string;
  take: number;
  verdict: Verdict;
  words?: string | null;
  worst?: WorstPlace | null;
}

/** How well the takes of a task agree before any training, and whether to record another. */
export interface TaskAgreement {
  takes: ComparedTake[];
  enough: boolean;
  advice: string;
  /** Why nothing can be trained from these takes together. */
  problem?: Failure | null;
}

/** A signal on a time line. */
export interface SignalMark {
  name: string;
  at_s: number;
  on: boolean;
}

/** A signal that a motion has set. */
export interface RunSignalMark {
  name: string;
  at_s: number;
  on: boolean;
  late_s: number;
}

/** Where a recording was held up. */
export interface PauseMark {
  at_s: number;
  length_s?: number | null;
}

export interface Trajectory {
  t_s: number[];
  joints_deg: number[][];
  signals: SignalMark[];
  pauses?: PauseMark[];
}

export interface Failure {
  code: string;
  message: string;
  advice: string;
}

export interface Progress {
  stage: string;
  words: string;
  done: number;
  total: number;
  fraction: number;
}

export interface Job {
  id: string;
  kind: "train_model";
  state: "queued" | "running" | "succeeded" | "failed" | "cancelled";
  task_id: string;
  model_id: string;
  attempt: number;
  progress: Progress;
  failure?: Failure | null;
  created_at: string;
}

/** How far the tool's path is from what was shown. */
export interface Fidelity {
  missed_mean_mm: number;
  missed_max_mm: number;
  mutual_mean_mm: number | null;
  /** Above 1 the path is further off than the takes are apart. */
  missed_over_mutual: number | null;
}

/** How well the takes agree, and whether to record another. */
export interface Agreement {
  enough: boolean;
  advice: string;
}

/** The figures of a training that the app shows. Other versions of the method may lack some. */
export interface Report {
  notes?: string[];
  agreement?: Agreement;
  k?: number;
  alpha_z?: number;
  n_basis?: number;
  objective?: number;
  gmcc?: number;
  e_j_deg?: number;
  bo_calls?: number;
  fidelity?: Fidelity | null;
}

export interface Model {
  id: string;
  task_id: string;
  version: number;
  state: "training" | "ready" | "failed" | "cancelled";
  job_id: string;
  demonstrations: string[];
  /** For each of these, the stretch that was used. */
  trims?: (Trim | null)[];
  method: string;
  seed: number;
  created_at: string;
  summary?: string | null;
  report?: Report | null;
  start_deg?: Joints | null;
  goal_deg?: Joints | null;
  duration_s?: number | null;
  failure?: Failure | null;
}

export interface Curve {
  t_s: number[];
  mean_deg: number[][];
  std_deg: number[][];
}

export type Placement = "as_taught" | "present" | { position: string } | { joints_deg: Joints };

export interface PlanRequest {
  model_id: string;
  robot?: string;
  start: Placement;
  goal: Placement;
  speed: number;
}

export interface Plan {
  plan: string;
  robot: string;
  model_id: string;
  start_deg: Joints;
  goal_deg: Joints;
  duration_s: number;
  approach_s: number;
  slowed_by: number;
  warnings: string[];
  verdict: string;
  t_s: number[];
  joints_deg: number[][];
  signals: SignalMark[];
}

export interface Reproduction {
  id: string;
  task_id: string;
  model_id: string;
  robot?: string | null;
  plan: string;
  state: "running" | "succeeded" | "stopped" | "failed";
  reason?: string | null;
  created_at: string;
  finished_at?: string | null;
  start_deg: Joints;
  goal_deg: Joints;
  e_j_deg?: number | null;
  e_j_commanded_deg?: number | null;
  gmcc?: number | null;
  tracking_error_deg?: TrackingError | null;
  armed_at?: string | null;
  cycles?: CycleCounts | null;
  duration_s: number;
  /** It led back along another motion. */
  backwards: boolean;
  outcome?: Outcome | null;
}

/** What a person said of a motion. */
export interface Outcome {
  worked: boolean;
  note?: string | null;
  at: string;
}

/** A pose of one robot under a name. */
export interface Position {
  id: string;
  robot: string;
  name: string;
  joints_deg: Joints;
  created_at: string;
}

export interface QuestionnaireDue {
  due: boolean;
}

export interface ReplyRequest {
  id: string;
  person: string;
  task_id: string;
  reproduction_id: string;
  /** From 1 to 5; missing when the person does not want to answer. */
  answers?: number[];
}

export type Grouping = "all" | "week" | "month";

/** The means of the answers about one task in one period. */
export interface QuestionnaireResult {
  task_id: string;
  task_name: string;
  /** The period's first day. */
  from: string;
  replies: number;
  mean: number[];
}

export interface RunSummary {
  id: string;
  task_id: string;
  task_name: string;
  robot?: string | null;
  state: Reproduction["state"];
  created_at: string;
  e_j_deg?: number | null;
  gmcc?: number | null;
  worked?: boolean | null;
}

export interface TaskSummary {
  task_id: string;
  name: string;
  runs: number;
  succeeded: number;
  judged: number;
  worked: number;
  e_j_mean_deg?: number | null;
  gmcc_mean?: number | null;
  last_run_at?: string | null;
}

export interface Dashboard {
  at: string;
  robots: RobotView[];
  jobs: Job[];
  runs: RunSummary[];
  tasks: TaskSummary[];
}

/** How far the arm was from where it was asked to be. */
export interface TrackingError {
  mean: number;
  max: number;
  max_by_joint?: Joints | null;
  rms_by_joint?: Joints | null;
}

export interface CycleCounts {
  total: number;
  lost: number;
  late: number;
  held: number;
  limited: number;
}

/** A flight record, thinned out so that every extreme survives. */
export interface Flight {
  end_s: number;
  t_s: number[];
  plan_t_s: number[];
  phase: (string | null)[];
  commanded_deg: number[][];
  commanded_min_deg: number[][];
  commanded_max_deg: number[][];
  measured_deg: number[][];
  measured_min_deg: number[][];
  measured_max_deg: number[][];
  error_max_deg: number[][];
  lost: number[];
  late: number[];
  held: number[];
  limited: number[];
  signals: RunSignalMark[];
}

export interface FlightEvent {
  at_s: number;
  code: string;
  message: string;
}

export type RobotState =
  "disconnected" | "idle" | "guiding" | "reproducing" | "stopping" | "faulted";

/** A signal that may be worked: a gripper, a vacuum. */
export interface SignalAnswer {
  name: string;
  label: string;
  /** What setting it does, as a verb: "close". */
  on: string;
  /** What resetting it does: "open". */
  off: string;
  is_on?: boolean | null;
}

export interface RobotView {
  id: string;
  name: string;
  kind: "virtual" | "gofa" | "none";
  state: RobotState;
  joints_deg?: Joints | null;
  age_ms: number;
  /** The link on which the arm is controlled. */
  egm: { connected: boolean; cycles: number; lost: number; late: number; real_time: boolean };
  lead_through?: boolean | null;
  hand?: "idle" | "returning" | "showing" | "leading" | null;
  fault?: Failure | null;
  run?: {
    phase: "approach" | "motion" | "paused" | "settling" | "stopping";
    speed: number;
    paused: boolean;
    /** Whether somebody holds the button; null when the arm moves by itself. */
    held: boolean | null;
    t_s: number;
    duration_s: number;
  } | null;
  signals: SignalAnswer[];
  /** The phone that may make the arm move; null when any may. */
  control?: ControlView | null;
  /** Whether the arm may move without anybody holding a button. */
  continuous_run: boolean;
}

export interface Phone {
  id: string;
  name: string;
}

export interface ControlView {
  phone: Phone;
  asked_by?: Phone | null;
}

/** What the server sends on the live socket. */
export type LiveMessage =
  | {
      type: "snapshot";
      robot: RobotView;
      demonstration?: Demonstration | null;
      jobs: Job[];
      reproduction?: Reproduction | null;
    }
  | { type: "robot"; robot: RobotView }
  | { type: "demonstration"; demonstration: Demonstration }
  | { type: "job"; job: Job }
  | { type: "model"; model: Model }
  | { type: "reproduction"; reproduction: Reproduction }
  /** Once for each drag that cannot begin or go on. */
  | { type: "drag_refused"; code: string; detail: string; advice: string };

/** What drags the soft virtual arm on the live socket: where the centre of the tool flange shall be
 *  in the base frame, turned about its own axes from how it was when the drag began. */
export type DragMessage =
  | { type: "drag"; tool_mm: [number, number, number]; turn_deg?: [number, number, number] }
  | { type: "drag_end" };
