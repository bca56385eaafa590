import { describe, expect, it } from "vitest";
import { sayAnswer } from "./answers";
import { Catalogue } from "./catalogue";

const catalogue = new Catalogue(
  {
    "Comparing the takes": "Vergleicht die Aufnahmen",
    Agrees: "Stimmt überein",
    "Not found": "Nicht gefunden",
    "Virtual robot": "Virtueller Roboter",
    "Another phone": "Ein anderes Telefon",
    Gripper: "Greifer",
    open: "aufmachen",
    close: "zumachen",
  },
  ",",
);

function said<T>(answer: T): T {
  const copy = structuredClone(answer);
  sayAnswer(copy, catalogue);
  return copy;
}

describe("an answer", () => {
  it("has its sentences said, wherever they stand", () => {
    expect(
      said([{ job: { progress: { stage: "alignment", words: "Comparing the takes" } } }]),
    ).toEqual([{ job: { progress: { stage: "alignment", words: "Vergleicht die Aufnahmen" } } }]);
    expect(said({ warnings: ["Not found", "?"] })).toEqual({ warnings: ["Nicht gefunden", "?"] });
    expect(said({ problem: { code: "open", message: "Not found" } })).toEqual({
      problem: { code: "open", message: "Nicht gefunden" },
    });
  });

  it("keeps names, codes, numbers and what is missing", () => {
    const kept = {
      name: "Not found",
      verdict: "open",
      state: "open",
      joints_deg: [[1.5, 2]],
      t_s: [0, 1],
      reason: null,
    };
    expect(said(kept)).toEqual(kept);
    expect(said(null)).toBeNull();
  });

  it("keeps what a person wrote about a motion", () => {
    const kept = { outcome: { worked: false, note: "Not found" } };
    expect(said(kept)).toEqual(kept);
  });

  it("says what the server calls the virtual robot and its gripper", () => {
    const gripper = {
      name: "GripperClose",
      label: "Gripper",
      on: "close",
      off: "open",
      is_on: true,
    };
    expect(said({ name: "Virtual robot", egm: {}, signals: [gripper] })).toEqual({
      name: "Virtueller Roboter",
      egm: {},
      signals: [{ ...gripper, label: "Greifer", on: "zumachen", off: "aufmachen" }],
    });
  });

  it("says what it calls a phone without a name, and no other", () => {
    const maria = { id: "2", name: "Marias Telefon" };
    expect(said({ phone: { id: "1", name: "Another phone" }, asked_by: maria })).toEqual({
      phone: { id: "1", name: "Ein anderes Telefon" },
      asked_by: maria,
    });
  });

  it("says a mark on a time line only what it is: on is not a word there", () => {
    const mark = { name: "GripperClose", at_s: 1.5, on: true };
    expect(said({ signals: [mark] })).toEqual({ signals: [mark] });
  });
});
