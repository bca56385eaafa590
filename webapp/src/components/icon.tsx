// The app's signs, drawn on a grid of 24. They always stand beside a word, so they are hidden
// from screen readers.

const PATHS = {
  check: "M4 12.5l5.5 5.5L20 7",
  cross: "M6 6l12 12M18 6L6 18",
  hand: "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-6.5a1.5 1.5 0 0 1 3 0V11m0-4.5a1.5 1.5 0 0 1 3 0V15a6 6 0 0 1-6 6c-3 0-4.5-1.5-6-4.5L4 13c-.5-1.5 1.5-2.5 2.5-1L8 14",
  move: "M3 12h16m-6-6l6 6-6 6",
  stop: "M7 7h10v10H7z",
  alert: "M12 3l10 18H2zM12 10v5m0 2.5v.5",
  unplugged: "M4 4l16 16M8 8l-3 3a4 4 0 0 0 0 6 4 4 0 0 0 6 0l2-2m3-3l2-2a4 4 0 0 0-6-6l-1 1",
  clock: "M12 3a9 9 0 1 0 .01 0zM12 7v5l3.5 2",
  record: "M12 6a6 6 0 1 0 .01 0z",
  plus: "M12 4v16M4 12h16",
  back: "M15 5l-7 7 7 7",
  next: "M9 5l7 7-7 7",
  play: "M7 4.5v15L19.5 12z",
  train: "M4 20V14m5.3 6V9m5.4 11v-8M20 20V4",
  eye: "M2 12c5-8 15-8 20 0-5 8-15 8-20 0zm10-3a3 3 0 1 0 .01 0z",
  bin: "M4 7h16M9 7V4h6v3M6 7l1 14h10l1-14",
  upload: "M12 16V4m-5 5l5-5 5 5M4 20h16",
  download: "M12 4v12m-5-5l5 5 5-5M4 20h16",
  pause: "M7 5h3v14H7zM14 5h3v14h-3z",
  pencil: "M4 20l1-5L16 4l4 4L9 19z",
  dots: "M5 12h.01M12 12h.01M19 12h.01",
  again: "M20 12a8 8 0 1 1-2.5-5.8M20 3v5h-5",
  cut: "M7 4l9 12M17 4L8 16M6 17.5a2.5 2.5 0 1 0 .01 0zM18 17.5a2.5 2.5 0 1 0 .01 0z",
  undo: "M4 9h10a5 5 0 0 1 0 10H8M8 5L4 9l4 4",
  camera: "M3 8h4l2-3h6l2 3h4v11H3zM12 10a3.5 3.5 0 1 0 .01 0z",
  globe: "M12 3a9 9 0 1 0 .01 0zM3 12h18M12 3c-5 5-5 13 0 18m0-18c5 5 5 13 0 18",
  info: "M12 3a9 9 0 1 0 .01 0zM12 11v6m0-10v.5",
  teach: "M4 20c2-6 5-3 7-8s4-6 9-8M20 4l-1 5m1-5l-5 1",
} as const;

export type IconName = keyof typeof PATHS;

/** Signs that are filled, because as outlines they would not be recognised. */
const FILLED: ReadonlySet<IconName> = new Set(["stop", "record", "play", "pause"]);

export function Icon({ name }: { name: IconName }) {
  const filled = FILLED.has(name);
  return (
    <svg class={filled ? "icon icon-filled" : "icon"} viewBox="0 0 24 24" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
