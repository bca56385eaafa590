import { expect, test } from "vitest";
import { Collection } from "./collection";

interface Thing {
  id: string;
  task: string;
  value: number;
}

test("a later version takes the place of the earlier one", () => {
  const things = new Collection<Thing>();
  things.put({ id: "a", task: "x", value: 1 });
  things.put({ id: "a", task: "x", value: 2 });
  expect(things.get("a")?.value).toBe(2);
  expect(things.where(() => true)).toHaveLength(1);
});

test("a fresh list removes what is gone, but only of its own task", () => {
  const things = new Collection<Thing>();
  things.put({ id: "a", task: "x", value: 1 }, { id: "b", task: "x", value: 1 });
  things.put({ id: "c", task: "y", value: 1 });
  things.replace((thing) => thing.task === "x", [{ id: "b", task: "x", value: 5 }]);
  expect(things.get("a")).toBeUndefined();
  expect(things.get("b")?.value).toBe(5);
  expect(things.get("c")?.value).toBe(1);
  things.forget("c");
  expect(things.get("c")).toBeUndefined();
});
