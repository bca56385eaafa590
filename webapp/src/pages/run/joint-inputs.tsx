// Six joint angles to type, each checked at once against its range.
import { checkJoint, JOINT_RANGES_DEG } from "../../format/joint-ranges";
import { degrees, fixed } from "../../format/numbers";
import { t } from "../../texts";

interface Props {
  values: readonly string[];
  onChange: (values: string[]) => void;
}

export function JointInputs({ values, onChange }: Props) {
  return (
    <div class="joint-inputs">
      {JOINT_RANGES_DEG.map((range, joint) => {
        const text = values[joint] ?? "";
        const verdict = checkJoint(joint, text);
        const limits = [degrees(range.lowest, 0), degrees(range.highest, 0)] as const;
        const hint = `joint-${joint}-hint`;
        return (
          <label key={joint} class="field">
            <span>{t.run.joint(joint + 1)}</span>
            <input
              inputMode="text"
              autoComplete="off"
              value={text}
              aria-invalid={verdict !== "ok"}
              aria-describedby={hint}
              onInput={(event) =>
                onChange(
                  JOINT_RANGES_DEG.map((_, at) =>
                    at === joint ? event.currentTarget.value : (values[at] ?? ""),
                  ),
                )
              }
            />
            <span id={hint} class={verdict === "ok" ? "hint" : "hint hint-bad"}>
              {verdict === "ok" && t.run.range(...limits)}
              {verdict === "not_number" && t.run.notNumber(fixed(12.5, 1))}
              {verdict === "out_of_range" && t.run.outOfRange(...limits)}
            </span>
          </label>
        );
      })}
    </div>
  );
}
