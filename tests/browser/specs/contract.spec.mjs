// The app's own description of the interface against the one that the server publishes: every
// request must exist, and every field the app reads must be there.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { BASE_URL } from "../support/phone.mjs";

const source = (name) =>
  readFile(new URL(`../../../webapp/src/api/${name}`, import.meta.url), "utf8");

/** Where the app's name is not the server's. */
const NAMES = {
  PlanRequest: "NewPlan",
  Progress: "JobProgress",
  ReplyRequest: "NewReply",
  RobotView: "RobotAnswer",
};
/** Described by the server as free JSON only. */
const FREE = new Set(["Report", "Fidelity", "Agreement"]);

const description = async () => (await fetch(new URL("/api/v1/openapi.json", BASE_URL))).json();

test("every request of the app is one that the server knows", async () => {
  const { paths } = await description();
  const known = Object.entries(paths).flatMap(([path, methods]) =>
    Object.keys(methods).map((method) => `${method.toUpperCase()} ${path}`),
  );
  const shapes = new Set(known.map((one) => one.replace(/\{\w+\}/g, "*")));
  const endpoints = await source("endpoints.ts");
  const requests = [...endpoints.matchAll(/request<[^>]*>\(\s*"(\w+)",\s*["`]([^"`]+)["`]/g)];
  assert.ok(requests.length > 20);
  for (const [, method, path] of requests) {
    // The action at the end of closeDemonstration's path is one of three.
    const actions = path.endsWith("/${action}") ? ["stop", "keep", "discard"] : [""];
    for (const action of actions) {
      const plain = path.replace("${action}", action).replace(/\?.*$/, "");
      const shape = `${method} ${plain.replace(/\$\{\w+\}/g, "*")}`;
      assert.ok(shapes.has(shape), shape);
    }
  }
});

test("every field that the app relies on is one that the server promises", async () => {
  const { schemas } = (await description()).components;
  const types = await source("types.ts");
  const interfaces = [...types.matchAll(/^export interface (\w+) \{\n(.*?)^\}/gms)];
  assert.ok(interfaces.length > 10);
  for (const [, name, body] of interfaces.filter(([, one]) => !FREE.has(one))) {
    const schema = schemas[NAMES[name] ?? name];
    assert.ok(schema, `the server describes no ${name}`);
    for (const [, field, optional] of body.matchAll(/^ {2}(\w+)(\??):/gm)) {
      assert.ok(field in schema.properties, `${name}.${field}`);
      const request = name.endsWith("Request");
      assert.ok(
        request || optional || schema.required.includes(field),
        `${name}.${field} may be missing`,
      );
    }
  }
});
