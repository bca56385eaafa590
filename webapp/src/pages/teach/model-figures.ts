// The figures of a training, as names and values.
import type { Model, Report } from "../../api/types";
import type { Figure } from "../../components/figures";
import { errorDegrees, fixed, millimetres, significant } from "../../format/numbers";
import { t } from "../../texts";

/** Figures that the report lacks come with null and are not shown. */
export function modelFigures(model: Model, report: Report): Figure[] {
  const names = t.teach.modelFigures;
  const { fidelity } = report;
  return [
    [names.e_j, show(report.e_j_deg, (value) => errorDegrees(value, 3))],
    [names.gmcc, show(report.gmcc, (value) => fixed(value, 4))],
    [names.missedMean, show(fidelity?.missed_mean_mm, millimetres)],
    [names.missedMax, show(fidelity?.missed_max_mm, millimetres)],
    [names.mutual, show(fidelity?.mutual_mean_mm, millimetres)],
    [names.k, show(report.k, String)],
    [names.alpha_z, show(report.alpha_z, (value) => fixed(value, 2))],
    [names.n_basis, show(report.n_basis, String)],
    [names.objective, show(report.objective, (value) => significant(value, 4))],
    [names.trials, show(report.bo_calls, String)],
    [names.takes, String(model.demonstrations.length)],
    [names.method, model.method],
  ];
}

function show(value: number | null | undefined, words: (value: number) => string): string | null {
  return typeof value === "number" && Number.isFinite(value) ? words(value) : null;
}
