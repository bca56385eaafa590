// The REST interface for specs: what a person does on the pages without being what is tested.
import assert from "node:assert/strict";
import { BASE_URL } from "./phone.mjs";

const PATIENCE_MS = 300_000;

async function request(method, path, body, type = "application/json") {
  const content = body === undefined ? {} : { body, headers: { "Content-Type": type } };
  const response = await fetch(new URL(`/api/v1${path}`, BASE_URL), { method, ...content });
  const text = await response.text();
  assert.ok(response.ok, `${method} ${path}: ${text}`);
  return text === "" ? null : JSON.parse(text);
}

export const get = (path) => request("GET", path);
export const post = (path, body) =>
  request("POST", path, body === undefined ? undefined : JSON.stringify(body));
export const put = (path, body) => request("PUT", path, JSON.stringify(body));
export const patch = (path, body) => request("PATCH", path, JSON.stringify(body));

/** A recorded file as a take that waits for a decision. */
export const upload = (task, name, csv) =>
  request("POST", `/tasks/${task}/demonstrations/upload?name=${name}`, csv, "text/csv");

/** Asks again and again until the answer is as wanted. */
export async function eventually(what, path, wanted) {
  const end = Date.now() + PATIENCE_MS;
  for (;;) {
    const answer = await get(path);
    if (wanted(answer)) return answer;
    assert.ok(Date.now() < end, `waited too long until ${what}: ${JSON.stringify(answer)}`);
  }
}
