// What a training found: a light and a sentence, the learned motion with its spread, and all
// figures folded.
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { getCurve } from "../../api/endpoints";
import type { Curve, Model } from "../../api/types";
import { Figures } from "../../components/figures";
import { Icon } from "../../components/icon";
import { LoadNotice, Notice } from "../../components/notice";
import { JointPanels, type Layer } from "../../plots/joint-panels";
import { useLoad } from "../../state/hooks";
import { t } from "../../texts";
import { modelFigures } from "./model-figures";
import { LIGHTS, verdictOf } from "./verdict";

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
  return (
    <>
      <TrafficLight model={model} />
      <Remarks model={model} />
      {model.report && (
        <details class="folded">
          <summary>{t.teach.allFigures}</summary>
          {model.summary && <p>{model.summary}</p>}
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

/** Whether the motion can be used: a sign, a word and a sentence, and a colour beside them. */
function TrafficLight({ model }: { model: Model }) {
  const { light, word, sentence } = verdictOf(model);
  const { tone, icon } = LIGHTS[light];
  return (
    <section class={`verdict tone-${tone}`}>
      <Icon name={icon} />
      <div>
        <strong>{word}</strong>
        <p>{sentence}</p>
      </div>
    </section>
  );
}

/** What the training has to say about the takes. */
function Remarks({ model: { report } }: { model: Model }) {
  const remarks = [...(report?.notes ?? [])];
  if (report?.agreement && !report.agreement.enough) remarks.unshift(report.agreement.advice);
  if (remarks.length === 0) return null;
  return (
    <Notice tone="plain" icon="info" title={t.teaching.verdict.remarks}>
      {remarks.map((remark) => (
        <p key={remark}>{remark}</p>
      ))}
    </Notice>
  );
}
