import { afterEach, expect, test, vi } from "vitest";
import { t } from "../texts";
import { request, whenUnauthorised } from "./client";
import type { Problem } from "./problem";

const answer = (status: number, body: string | null) =>
  vi.stubGlobal(
    "fetch",
    vi.fn(async () => new Response(body, { status })),
  );
const refused = (promise: Promise<unknown>): Promise<Problem> =>
  promise.then(
    () => expect.unreachable("it should have been refused"),
    (problem: Problem) => problem,
  );

afterEach(() => vi.unstubAllGlobals());

test("answers come as values, an empty one as null", async () => {
  answer(200, '{"id":"a"}');
  expect(await request("GET", "/tasks/a")).toEqual({ id: "a" });
  answer(204, null);
  expect(await request("POST", "/robots/stop")).toBeNull();
});

test("bodies are JSON, files go as they are with their name's type", async () => {
  answer(200, "{}");
  await request("POST", "/tasks", { body: { name: "x" } });
  expect(fetch).toHaveBeenLastCalledWith(
    "/api/v1/tasks",
    expect.objectContaining({ method: "POST", body: '{"name":"x"}' }),
  );
  const file = new Blob(["t_s,q1"], { type: "text/csv" });
  await request("POST", "/upload", { file });
  expect(fetch).toHaveBeenLastCalledWith(
    "/api/v1/upload",
    expect.objectContaining({
      body: file,
      headers: expect.objectContaining({ "Content-Type": "text/csv" }),
    }),
  );
});

test("a refusal is thrown with the server's words", async () => {
  answer(409, '{"code":"robot_busy","detail":"The arm is moving.","advice":"Wait."}');
  const problem = await refused(request("POST", "/reproductions"));
  expect(problem).toMatchObject({ code: "robot_busy", detail: "The arm is moving.", status: 409 });
});

test("an error page that is not JSON is a problem all the same", async () => {
  answer(502, "<html>Bad gateway</html>");
  expect((await refused(request("GET", "/tasks"))).detail).toContain("502");
});

test("no answer at all is said to be the network", async () => {
  vi.stubGlobal("fetch", vi.fn().mockRejectedValue(new TypeError("failed")));
  const problem = await refused(request("GET", "/tasks"));
  expect(problem).toMatchObject({ code: "unreachable", detail: t.problems.unreachable });
});

test("a missing pairing is announced", async () => {
  const listener = vi.fn();
  whenUnauthorised(listener);
  answer(401, '{"code":"not_paired","detail":"x","advice":"y"}');
  await refused(request("GET", "/tasks"));
  expect(listener).toHaveBeenCalledOnce();
});
