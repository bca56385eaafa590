import { expect, test } from "vitest";
import { link, pairingCode, parse, type Route } from "./router";

test("every screen has an address that leads back to it", () => {
  const routes: Exclude<Route, { page: "missing" }>[] = [
    { page: "teach" },
    { page: "new-task" },
    { page: "task", task: "a/b" },
    { page: "more", task: "t" },
    { page: "record", task: "t" },
    { page: "take", task: "t", take: "d 1" },
    { page: "model", task: "t", model: "m" },
    { page: "robots" },
    { page: "dashboard" },
    { page: "language" },
    { page: "run" },
    { page: "setup", task: "t" },
    { page: "preview", task: "t" },
    { page: "motion", task: "t", motion: "r" },
    { page: "questions", task: "t", motion: "r" },
    { page: "positions", task: "t" },
  ];
  for (const route of routes) expect(parse(link(route))).toEqual(route);
});

test("the bare address is Teach, an unknown one is said to be missing", () => {
  expect(parse("")).toEqual({ page: "teach" });
  expect(parse("#/")).toEqual({ page: "teach" });
  expect(parse("#/nonsense")).toEqual({ page: "missing" });
  expect(parse("#/run/t/motions")).toEqual({ page: "missing" });
  expect(parse("#/teach/%zz")).toEqual({ page: "task", task: "%zz" });
});

test("a pairing code is read from the address", () => {
  expect(pairingCode("#pair=123456")).toBe("123456");
  expect(pairingCode("#/teach")).toBeNull();
  expect(pairingCode("#pair=")).toBeNull();
});
