// How a screen asks the server: once when it opens, and on a press.
import { useSignal, type Signal } from "@preact/signals";
import { useCallback, useEffect, useRef } from "preact/hooks";
import { asProblem, type Problem } from "../api/problem";
import { snapshots } from "./live";
import { give } from "./signals-to-hand";

export interface Load {
  loading: boolean;
  problem: Problem | null;
  again: () => void;
}

/** Runs `load` when the screen opens, when `key` changes, and after every reconnect. */
export function useLoad(load: () => Promise<void>, key: string): Load {
  const state = useSignal<{ loading: boolean; problem: Problem | null }>({
    loading: true,
    problem: null,
  });
  const latest = useRef(load);
  latest.current = load;
  const again = useCallback(() => {
    state.value = { loading: true, problem: state.peek().problem };
    latest.current().then(
      () => (state.value = { loading: false, problem: null }),
      (error: unknown) => (state.value = { loading: false, problem: asProblem(error) }),
    );
  }, []);
  useEffect(again, [key, snapshots.value]);
  return { ...state.value, again };
}

export interface Action {
  busy: boolean;
  problem: Problem | null;
  start: () => void;
  forget: () => void;
}

/** Something that a press starts: one at a time, with its problem kept to be shown. */
export function useAction(action: () => Promise<void>): Action {
  const busy: Signal<boolean> = useSignal(false);
  const problem: Signal<Problem | null> = useSignal<Problem | null>(null);
  const start = () => {
    if (busy.peek()) return;
    busy.value = true;
    problem.value = null;
    action()
      .catch((error: unknown) => {
        problem.value = asProblem(error);
        give("refused");
      })
      .finally(() => (busy.value = false));
  };
  return {
    busy: busy.value,
    problem: problem.value,
    start,
    forget: () => (problem.value = null),
  };
}
