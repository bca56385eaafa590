// A task at a glance: its photo, or its initials on a colour of its own.
import { pictureAddress } from "../api/endpoints";
import type { Task } from "../api/types";

/** Grounds on which white is easy to read. */
const COLOURS = [
  "#0b4a8f",
  "#0b5423",
  "#6b3f00",
  "#950000",
  "#5b2a86",
  "#004d4d",
  "#7a0f4f",
  "#3f464d",
] as const;

export function TaskPicture({ task }: { task: Task }) {
  if (task.picture) {
    return (
      <img
        class="task-picture"
        src={pictureAddress(task.id, task.picture)}
        alt=""
        width={64}
        height={64}
        loading="lazy"
      />
    );
  }
  return (
    // The letters are drawn by the style sheet: a picture, not words that a row would have to say.
    <span
      class="task-picture"
      style={{ background: colourOf(task.id) }}
      data-initials={initials(task.name)}
      aria-hidden="true"
    />
  );
}

/** The first letters of the first two words. */
export function initials(name: string): string {
  const words = name.split(/\s+/).filter((word) => /[\p{L}\p{N}]/u.test(word));
  const letters = words.map((word) => word.replace(/^[^\p{L}\p{N}]+/u, ""));
  return letters
    .slice(0, 2)
    .map((word) => [...word][0] ?? "")
    .join("")
    .toLocaleUpperCase();
}

/** The same for one task for ever. */
export function colourOf(id: string): string {
  let sum = 0;
  for (const letter of id) sum = (sum * 31 + (letter.codePointAt(0) ?? 0)) % 65_521;
  return COLOURS[sum % COLOURS.length] ?? COLOURS[0];
}
