// How far something is, in words and as a bar.

interface Props {
  label: string;
  /** From 0 to 1; null when it is not known. */
  fraction: number | null;
  words: string;
}

export function Progress({ label, fraction, words }: Props) {
  const percent = fraction === null ? null : Math.round(100 * Math.min(1, Math.max(0, fraction)));
  return (
    <div class="progress">
      <p class="progress-words">{words}</p>
      <div
        class="progress-track"
        role="progressbar"
        aria-label={label}
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={percent ?? undefined}
        aria-valuetext={words}
      >
        <div
          // Another element when the fraction becomes known: it must not glide down from full.
          key={percent === null ? "unknown" : "known"}
          class={percent === null ? "progress-bar progress-unknown" : "progress-bar"}
          style={{ width: `${percent ?? 100}%` }}
        />
      </div>
    </div>
  );
}
