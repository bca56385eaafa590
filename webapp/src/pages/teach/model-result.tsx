// What a training found: a sentence, the learned motion with its spread, and all figures folded.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { getCurve } from "../../api/endpoints";
import type { Curve, Model } from "../../api/types";
import { Figures } from "../../components/figures";
import { LoadNotice, Notice } from "../../components/notice";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { modelFigures } from "./model-figures";

export function ModelResult({ model }: { model: Model }) {
  const curve = useSignal<Curve | null>(null);
  const load = useLoad(async () => {
    curve.value = await getCurve(model.id, 300);
  }, model.id);
  const shown = curve.value;
  const layers = useMemo<Layer[]>(
    () => (shown ? [{ label: t.plot.degrees, joints: shown.mean_deg, look: "strong" }] : []),
    [shown],
  );
  const far = (model.report?.fidelity?.missed_over_mutual ?? 0) > 1;
  return (
    <>
      {model.summary && (
        <Notice tone={far ? "soft" : "good"} icon={far ? "alert" : "check"}>
          <p>{model.summary}</p>
        </Notice>
      )}
      {model.report?.agreement && (
        <Notice
          tone={model.report.agreement.enough ? "good" : "soft"}
          icon={model.report.agreement.enough ? "check" : "info"}
        >
          <p>{model.report.agreement.advice}</p>
        </Notice>
      )}
      {model.report?.notes?.map((note) => (
        <Notice key={note} tone="plain" icon="info">
          <p>{note}</p>
        </Notice>
      ))}
      {model.report && (
        <details class="folded">
          <summary>{t.teach.allFigures}</summary>
          <Figures list={modelFigures(model, model.report)} />
        </details>
      )}
      <LoadNotice load={load} empty={shown === null} />
      {shown && (
        <>
          <JointPanels
            title={t.teach.bandPlot}
            timesS={shown.t_s}
            layers={layers}
            bandDeg={shown.std_deg}
          />
          <p class="hint">{t.teach.bandHint}</p>
        </>
      )}
    </>
  );
}
