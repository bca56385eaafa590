// Names and values below each other.

export type Figure = readonly [name: string, value: string | null];

/** Figures that are not there are left out. */
export function Figures({ list }: { list: readonly Figure[] }) {
  return (
    <dl class="figures">
      {list.map(
        ([name, value]) =>
          value !== null && (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ),
      )}
    </dl>
  );
}
