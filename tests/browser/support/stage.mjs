// Puts a page into a state that passes by quickly on a real server: the answers of that moment are
// given again and again. Everything else comes from the server, but nothing is changed there.

/** How far back the traces of a staged robot reach, and how far apart its messages are. */
const PAST_MS = 10_000;
const STEP_MS = 50;

/** What a stage may say: `answers` by path, `live` as the snapshot of the live socket, `curve` for
 *  the joints that the robot goes through, `lost` when the connection breaks right after that. */
export async function openStages(context) {
  let stage = {};
  await context.route("**/api/v1/**", async (route) => {
    const request = route.request();
    const path = new URL(request.url()).pathname.replace("/api/v1", "");
    const answer = stage.answers?.[path];
    if (answer !== undefined && request.method() === "GET") return route.fulfill({ json: answer });
    const free = path === "/plans" || (stage.uploads && path.endsWith("/upload"));
    if (request.method() === "GET" || free) return route.continue();
    return route.abort();
  });
  await context.routeWebSocket(/\/api\/v1\/live\?/, (socket) => {
    const own = stage;
    if (own.live) return play(socket, own);
    if (!own.lost) return void socket.connectToServer();
    return socket.close();
  });
  return (next = {}) => (stage = next);
}

function play(socket, { live, curve, lost }) {
  const send = (message) => socket.send(JSON.stringify(message));
  const robot = (ageMs) => ({
    ...live.robot,
    age_ms: ageMs,
    joints_deg: curve ? curve(ageMs) : live.robot.joints_deg,
  });
  send({ type: "snapshot", jobs: [], ...live, robot: robot(PAST_MS) });
  for (let age = PAST_MS; age > 0; age -= STEP_MS) send({ type: "robot", robot: robot(age) });
  if (lost) return socket.close();
  const timer = setInterval(() => send({ type: "robot", robot: robot(40) }), 500);
  socket.onClose(() => clearInterval(timer));
  return undefined;
}

/** The recorded joints as a function of how long ago they were. */
export function curveOf({ t_s: times, joints_deg: joints }) {
  const perStep = (times.at(-1) - times[0]) / (times.length - 1);
  return (ageMs) => {
    const at = Math.max(0, times.length - 1 - Math.round(ageMs / 1000 / perStep));
    return joints.map((angles) => angles[at]);
  };
}
