import { render } from "preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Demonstration, DemonstrationState, TaskAgreement } from "../../api/types";
import { counts, fits, useAgreement } from "../../state/agreement";
import { demonstrations } from "../../state/entities";
import { t } from "../../texts";
import { TakeList } from "./take-list";
import { TakesAdvice } from "./takes-advice";

const take = (number: number, state: DemonstrationState): Demonstration => ({
  id: `d${number}`,
  task_id: "t",
  take: number,
  state,
  source: "virtual_hand",
  created_at: "",
  duration_s: 5,
  samples: 500,
  rate_hz: 100,
  gaps: 0,
  usable: true,
});
const agreement = (ids: string[], rest: Partial<TaskAgreement> = {}): TaskAgreement => ({
  takes: ids.map((id) => ({ id, take: Number(id.slice(1)), verdict: "open" })),
  enough: false,
  advice: `about ${ids.join(" and ")}`,
  ...rest,
});

function Shown() {
  const compared = useAgreement("t");
  const takes = demonstrations.where(() => true);
  return (
    <>
      <TakesAdvice compared={compared} />
      <TakeList task="t" takes={takes} agreement={compared.agreement} />
    </>
  );
}

let place: HTMLElement;
/** Requests for the agreement that wait for an answer. */
let asked: ((answer: Response) => void)[];
const words = () => place.querySelector("[role=status]")?.textContent;
const answer = (body: TaskAgreement, request: number) =>
  asked[request]!(new Response(JSON.stringify(body)));

beforeEach(() => {
  place = document.createElement("div");
  document.body.append(place);
  asked = [];
  vi.stubGlobal("fetch", (path: string) =>
    path.endsWith("/agreement")
      ? new Promise<Response>((resolve) => asked.push(resolve))
      : Promise.resolve(new Response(JSON.stringify({ t_s: [], joints_deg: [] }))),
  );
  demonstrations.replace(() => true, []);
});
afterEach(() => {
  render(null, place);
  place.remove();
  vi.unstubAllGlobals();
});

test("recorded and kept takes count", () => {
  const states: DemonstrationState[] = ["preparing", "recording", "discarded", "interrupted"];
  expect(states.some((state) => counts(take(1, state)))).toBe(false);
  expect(counts(take(1, "recorded")) && counts(take(1, "kept"))).toBe(true);
});

test("an answer fits the takes that it is about", () => {
  const takes = [take(1, "kept"), take(2, "recorded"), take(3, "discarded")];
  expect(fits(agreement(["d1", "d2"]), takes)).toBe(true);
  expect(fits(agreement(["d1"]), takes)).toBe(false);
  expect(fits(agreement(["d1", "d2", "d3"]), takes)).toBe(false);
  // The take's own page knows no other takes.
  expect(fits(agreement(["d1", "d2"]), [take(2, "recorded")])).toBe(true);
});

test("there is a word while the takes are compared, then the advice and a mark for each", async () => {
  demonstrations.put(take(1, "kept"), take(2, "kept"));
  render(<Shown />, place);
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  expect(words()).toBe(t.teach.comparing);
  const body = agreement(["d1", "d2"], { advice: "Take 2 differs from the others." });
  body.takes[0] = { id: "d1", take: 1, verdict: "agrees", words: "Agrees" };
  body.takes[1] = { id: "d2", take: 2, verdict: "differs", words: "Differs most at joint 4" };
  answer(body, 0);
  await vi.waitFor(() => expect(words()).toBe("Take 2 differs from the others."));
  const rows = [...place.querySelectorAll("a")].map((row) => row.getAttribute("aria-label"));
  expect(rows).toEqual([
    "Take 1, Kept, Agrees, 5.0 s",
    "Take 2, Kept, Differs most at joint 4, 5.0 s",
  ]);
  expect(place.querySelectorAll("a")[1]!.textContent).toContain("Differs most at joint 4");
});

test("a new take is compared again, and a late answer about the old ones is not shown", async () => {
  demonstrations.put(take(1, "kept"));
  render(<Shown />, place);
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  demonstrations.put(take(2, "recorded"));
  await vi.waitFor(() => expect(asked).toHaveLength(2));
  answer(agreement(["d1", "d2"], { enough: true }), 1);
  await vi.waitFor(() => expect(words()).toBe("about d1 and d2"));
  expect(place.querySelector(".notice")!.className).toContain("tone-good");
  answer(agreement(["d1"]), 0);
  demonstrations.put(take(3, "recording"));
  await vi.waitFor(() => expect(place.querySelectorAll("a")).toHaveLength(3));
  expect(words()).toBe("about d1 and d2");
});

test("takes that could not be compared are said to be so, with a way to try again", async () => {
  demonstrations.put(take(7, "kept"));
  render(<Shown />, place);
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  const problem = { status: 500, detail: "It broke.", advice: "Try again.", code: "x" };
  asked[0]!(new Response(JSON.stringify(problem), { status: 500 }));
  await vi.waitFor(() => expect(place.querySelector("[role=alert]")).not.toBeNull());
  place.querySelector("button")!.click();
  await vi.waitFor(() => expect(asked).toHaveLength(2));
  answer(agreement(["d7"]), 1);
  await vi.waitFor(() => expect(words()).toBe("about d7"));
});
