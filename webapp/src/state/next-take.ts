// Which task's next take begins at once when its recording page opens: what "record another" leads
// to. A reload forgets it, so no arm goes soft because a page was loaded.
let wanted: string | null = null;

export function recordAtOnce(task: string): void {
  wanted = task;
}

/** Whether it was asked for; asking uses it up. */
export function isAtOnce(task: string): boolean {
  const asked = wanted === task;
  wanted = null;
  return asked;
}
