// The time of something recorded or planned: a slider that a glove can hold, and play and pause.
import type { Signal } from "@preact/signals";
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { duration } from "../format/numbers";
import { t } from "../texts";
import { Button } from "./button";

interface Props {
  time: Signal<number>;
  endS: number;
  /** Plays once as soon as it appears, unless the phone asks for little movement. */
  playAtOnce?: boolean;
  /** What else is known about this moment. */
  children?: ComponentChildren;
}

export function ReplaySlider({ time, endS, playAtOnce = false, children }: Props) {
  const playing = useSignal(playAtOnce && !matchMedia("(prefers-reduced-motion: reduce)").matches);
  useEffect(() => {
    if (!playing.value) return;
    let last = performance.now();
    let frame = requestAnimationFrame(function advance(now) {
      time.value = Math.min(endS, time.peek() + Math.max(0, now - last) / 1000);
      last = now;
      if (time.peek() < endS) frame = requestAnimationFrame(advance);
      else playing.value = false;
    });
    return () => cancelAnimationFrame(frame);
  }, [playing.value, endS]);
  const toggle = () => {
    if (!playing.peek() && time.peek() >= endS) time.value = 0;
    playing.value = !playing.peek();
  };
  const words = t.flight.at(duration(time.value), duration(endS));
  return (
    <div class="replay-slider">
      <p class="replay-time">
        <strong>{words}</strong>
        {children}
      </p>
      <div class="replay-row">
        <Button icon={playing.value ? "pause" : "play"} onPress={toggle}>
          {playing.value ? t.flight.pause : t.flight.play}
        </Button>
        <input
          type="range"
          min="0"
          max={endS}
          step="any"
          value={time.value}
          aria-label={t.flight.slider}
          aria-valuetext={words}
          onInput={(event) => {
            playing.value = false;
            time.value = event.currentTarget.valueAsNumber;
          }}
        />
      </div>
    </div>
  );
}
