// The server's sentences in Italian, by topic: English as it stands in the server's sources, then the translation.
import controller from "./controller.json";
import learning from "./learning.json";
import planning from "./planning.json";
import robot from "./robot.json";
import server from "./server.json";

export const it: Record<string, string> = {
  ...controller,
  ...learning,
  ...planning,
  ...robot,
  ...server,
};
