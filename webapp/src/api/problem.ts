// Errors as the worker sees them: what was wrong, where, and what to do.
import { atMost } from "../format/numbers";
import { t } from "../texts";

export interface ProblemDocument {
  title?: string;
  status?: number;
  code?: string;
  detail?: string;
  where?: unknown;
  advice?: string;
}

export class Problem extends Error {
  constructor(
    readonly code: string,
    readonly detail: string,
    readonly advice: string,
    readonly status: number,
    readonly where: string | null = null,
  ) {
    super(detail);
  }
}

/** A refusal of the server; it may lack any member, and then we still say something useful. */
export function fromDocument(document: ProblemDocument, status: number): Problem {
  return new Problem(
    document.code ?? "unknown",
    document.detail ?? document.title ?? t.problems.refused(status),
    document.advice ?? t.problems.tryAgain,
    status,
    describeWhere(document.where),
  );
}

/** The server did not answer at all. */
export function unreachable(): Problem {
  return new Problem("unreachable", t.problems.unreachable, t.problems.checkNetwork, 0);
}

/** Whatever was thrown, as a problem to show. */
export function asProblem(error: unknown): Problem {
  if (error instanceof Problem) return error;
  const detail = error instanceof Error ? error.message : String(error);
  return new Problem("unexpected", detail, t.problems.tryAgain, 0);
}

/** The parts of a place that mean something to the person at the arm; the rest is for programs. */
function describeWhere(where: unknown): string | null {
  if (typeof where !== "object" || where === null) return null;
  const parts = Object.entries(where).flatMap(([key, value]) => {
    const words = t.problems.places[key];
    const plain = typeof value === "number" ? atMost(value, 2) : value;
    return words && typeof plain === "string" ? [words(plain)] : [];
  });
  return parts.length > 0 ? parts.join(", ") : null;
}
