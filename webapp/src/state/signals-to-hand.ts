// Short tones and vibrations beside what the screen shows, for somebody who looks at the arm. They
// say nothing that is not on the screen too: many phones can't vibrate, and halls are loud.
import { effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { recall, remember } from "./browser-store";
import { demonstrations, reproductions } from "./entities";
import { route } from "./navigation";

export type Cue = "tick" | "recording began" | "recording ended" | "motion ended" | "refused";

interface Sign {
  /** Frequencies in hertz, one after the other. */
  tones: readonly number[];
  /** Milliseconds of trembling and rest, in turns. */
  pattern: readonly number[];
}

/** Upwards begins, downwards ends; a low pair is a no. */
const SIGNS: Record<Cue, Sign> = {
  tick: { tones: [880], pattern: [40] },
  "recording began": { tones: [660, 990], pattern: [200] },
  "recording ended": { tones: [990, 660], pattern: [80, 60, 80] },
  "motion ended": { tones: [784, 988, 784], pattern: [80, 60, 200] },
  refused: { tones: [220, 220], pattern: [60, 50, 60, 50, 60] },
};
const TONE_S = 0.12;
const LOUDNESS = 0.2;
const MUTED = "team.muted";

/** Whether this phone is silent; it remembers. */
export const muted = signal(recall(MUTED) === "yes");

export function mute(on: boolean): void {
  muted.value = on;
  remember(MUTED, on ? "yes" : "no");
}

let audio: AudioContext | null = null;

/** Makes ready for tones: a browser plays none before a person has touched the page. */
export function listenForTouch(): void {
  const touched = () => {
    if (muted.peek() || !("AudioContext" in window)) return;
    audio ??= new AudioContext();
    if (audio.state === "suspended") audio.resume().catch(() => undefined);
  };
  document.addEventListener("pointerdown", touched);
  document.addEventListener("keydown", touched);
}

export function give(cue: Cue): void {
  if (muted.peek()) return;
  const { tones, pattern } = SIGNS[cue];
  // Before the first touch a browser refuses; on iPhones there is nothing to call.
  navigator.vibrate?.([...pattern]);
  if (audio?.state !== "running") return;
  for (const [index, hertz] of tones.entries())
    play(audio, hertz, audio.currentTime + index * TONE_S);
}

function play(context: AudioContext, hertz: number, atS: number): void {
  const tone = new OscillatorNode(context, { frequency: hertz });
  const volume = new GainNode(context, { gain: 0 });
  // Without a rise and a fall each tone begins and ends with a crack.
  volume.gain.setValueAtTime(0, atS);
  volume.gain.linearRampToValueAtTime(LOUDNESS, atS + 0.01);
  volume.gain.setValueAtTime(LOUDNESS, atS + TONE_S - 0.03);
  volume.gain.linearRampToValueAtTime(0, atS + TONE_S - 0.01);
  tone.connect(volume).connect(context.destination);
  tone.start(atS);
  tone.stop(atS + TONE_S);
}

/** A tick for each number of a count-in. */
export function useCountInTicks(count: number | null): void {
  useEffect(() => {
    if (count !== null) give("tick");
  }, [count]);
}

/** The state of what this phone shows, if it is a recording or a motion. */
function shown(): { id: string; state: string | undefined } | null {
  const here = route.value;
  if (here.page === "take") return { id: here.take, state: demonstrations.get(here.take)?.state };
  if (here.page === "motion")
    return { id: here.motion, state: reproductions.get(here.motion)?.state };
  return null;
}

/** What a change from one state to another is worth. */
export function cueFor(before: string | undefined, after: string | undefined): Cue | null {
  if (before === after || before === undefined) return null;
  if (after === "recording") return "recording began";
  if (before === "recording" || before === "preparing") return "recording ended";
  if (before === "running") return "motion ended";
  return null;
}

/** Follows the recording or motion on the screen and gives a sign when it begins and ends. */
export function followScreen(): () => void {
  let last: ReturnType<typeof shown> = null;
  return effect(() => {
    const now = shown();
    const cue = last !== null && last.id === now?.id ? cueFor(last.state, now.state) : null;
    last = now;
    if (cue !== null) give(cue);
  });
}
