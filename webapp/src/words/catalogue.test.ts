import { describe, expect, it } from "vitest";
import { Catalogue } from "./catalogue";

const german = new Catalogue(
  {
    "the arm is busy": "der Arm ist beschäftigt",
    "Start it again when the arm may move.": "Starten Sie neu, wenn der Arm sich bewegen darf.",
    "{} Then acknowledge the fault.": "{} Quittieren Sie dann die Störung.",
    "take {take} can't be used: {error}": "Aufnahme {take} ist nicht brauchbar: {error}",
    "take {}": "Aufnahme {}",
    "{name}: not a readable recording: {reason}": "{name}: keine lesbare Aufzeichnung: {reason}",
    "{name}: joint {joint} stands at {value_deg:.1}° in row {row}":
      "{name}: Zeile {row}, Achse {joint}: {value_deg}°",
    "the file is empty": "die Datei ist leer",
    "the {which} of joint {joint} is {value_deg:.1}°": "{which} von Achse {joint}: {value_deg}°",
    start: "Anfang",
    "The robot is busy ({})": "Der Roboter ist beschäftigt ({})",
    '"{label}" did not {wish}': "„{label}“ hat nicht reagiert auf: {wish}",
    "{others} shows another motion than {most}": "{others} zeigt eine andere Bewegung als {most}",
    "{} and {last}": "{} und {last}",
    "{before}, then {step}": "{before}, dann {step}",
    "{name} switched on": "{name} eingeschaltet",
    "{name} switched off": "{name} ausgeschaltet",
    "{name} works the signals differently ({does}) from {other}":
      "{name} schaltet die Signale anders als {other} ({does})",
    "Learned from {takes} takes.": "Aus {takes} Aufnahmen gelernt.",
    "The arm will end {:.2}° from the goal on average.": "Der Arm endet {}° neben dem Ziel.",
    "the robot controller refuses {path}: {message}": "die Steuerung lehnt {path} ab: {message}",
    "joint {} is not a number": "Achse {} ist keine Zahl",
    "joint {} is not a number at {t_s:.2} s": "Achse {} ist nach {t_s} s keine Zahl",
    "{} differs from the others, most {} at joint {}. Discard it.":
      "{} weicht bei Achse {2} ab, am meisten {1}. Verwerfen Sie sie.",
    "{} (event {code}: {title})": "{} (Ereignis {code}: {title})",
    "at the end": "am Ende",
    Gripper: "Greifer",
    close: "zumachen",
  },
  ",",
);

const said = (text: string) => german.translate(text);

describe("a sentence of the server", () => {
  it("is said with the letter and the stop that it came with", () => {
    expect(said("The arm is busy.")).toBe("Der Arm ist beschäftigt.");
    expect(said("the arm is busy")).toBe("der Arm ist beschäftigt");
    expect(said("Start it again when the arm may move.")).toBe(
      "Starten Sie neu, wenn der Arm sich bewegen darf.",
    );
  });

  it("stays as it is when nobody knows it", () => {
    expect(said("Load 12.5 kg into the press.")).toBe("Load 12.5 kg into the press.");
    expect(said("")).toBe("");
    expect(said("start of the line")).toBe("start of the line");
    expect(said("Bolts and nuts")).toBe("Bolts and nuts");
  });

  it("has its numbers written as the country does", () => {
    expect(said("The arm will end 0.25° from the goal on average.")).toBe(
      "Der Arm endet 0,25° neben dem Ziel.",
    );
    expect(said("take_3.csv: joint 2 stands at -170.5° in row 17.")).toBe(
      "take_3.csv: Zeile 17, Achse 2: -170,5°.",
    );
  });

  it("may have gaps at either end", () => {
    expect(said("Start it again when the arm may move. Then acknowledge the fault.")).toBe(
      "Starten Sie neu, wenn der Arm sich bewegen darf. Quittieren Sie dann die Störung.",
    );
    expect(said("Take 2 shows another motion than take 1 and take 3.")).toBe(
      "Aufnahme 2 zeigt eine andere Bewegung als Aufnahme 1 und Aufnahme 3.",
    );
  });

  it("may stand inside another one, as deep as it likes", () => {
    expect(said("Take 3 can't be used: take 3: not a readable recording: the file is empty.")).toBe(
      "Aufnahme 3 ist nicht brauchbar: Aufnahme 3: keine lesbare Aufzeichnung: die Datei ist leer.",
    );
    expect(said("The start of joint 2 is 200.0°.")).toBe("Anfang von Achse 2: 200,0°.");
  });

  it("may have another order of words", () => {
    expect(said("Take 2 differs from the others, most at the end at joint 3. Discard it.")).toBe(
      "Aufnahme 2 weicht bei Achse 3 ab, am meisten am Ende. Verwerfen Sie sie.",
    );
  });

  it("is not taken for a shorter one that begins the same", () => {
    expect(said("Joint 3 is not a number at 1.50 s.")).toBe("Achse 3 ist nach 1,50 s keine Zahl.");
    expect(said("Joint 3 is not a number.")).toBe("Achse 3 ist keine Zahl.");
  });

  it("may be followed by others", () => {
    expect(said("Learned from 3 takes. The arm will end 0.25° from the goal on average.")).toBe(
      "Aus 3 Aufnahmen gelernt. Der Arm endet 0,25° neben dem Ziel.",
    );
    expect(said("The arm is busy. Feed the cat.")).toBe("Der Arm ist beschäftigt. Feed the cat.");
  });

  it("lists what it lists", () => {
    expect(said("Take 4 shows another motion than take 1, take 2 and take 3.")).toBe(
      "Aufnahme 4 zeigt eine andere Bewegung als Aufnahme 1, Aufnahme 2 und Aufnahme 3.",
    );
    expect(
      said(
        "Take 1 works the signals differently (Clamp switched on, then Clamp switched off, then X switched on) from take 2.",
      ),
    ).toBe(
      "Aufnahme 1 schaltet die Signale anders als Aufnahme 2 (Clamp eingeschaltet, dann Clamp ausgeschaltet, dann X eingeschaltet).",
    );
  });

  it("keeps names that people gave and words of others", () => {
    expect(said("start: not a readable recording: expected `,` at line 3.")).toBe(
      "start: keine lesbare Aufzeichnung: expected `,` at line 3.",
    );
    expect(said("The robot controller refuses /rw/panel: Not allowed. Ask someone.")).toBe(
      "Die Steuerung lehnt /rw/panel ab: Not allowed. Ask someone.",
    );
    expect(said("the arm is busy (event 90520: Jog the arm)")).toBe(
      "der Arm ist beschäftigt (Ereignis 90520: Jog the arm)",
    );
    expect(said("Take this and last.")).toBe("Take this and last.");
    expect(said('"Zange" did not spannen.')).toBe("„Zange“ hat nicht reagiert auf: spannen.");
    expect(said('"Gripper" did not close.')).toBe("„Greifer“ hat nicht reagiert auf: zumachen.");
  });

  it("may lack the name of its recording", () => {
    expect(
      said("Not a readable recording: the file is empty. Start it again when the arm may move."),
    ).toBe(
      "Keine lesbare Aufzeichnung: die Datei ist leer. Starten Sie neu, wenn der Arm sich bewegen darf.",
    );
  });
});
