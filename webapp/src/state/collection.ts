// What the app knows of one kind of thing, by id. Both answers and live messages end up here, so
// that every screen shows the same.
import { signal, type ReadonlySignal } from "@preact/signals";

export interface Identified {
  id: string;
}

export class Collection<T extends Identified> {
  private readonly items = signal<ReadonlyMap<string, T>>(new Map());

  get view(): ReadonlySignal<ReadonlyMap<string, T>> {
    return this.items;
  }

  get(id: string): T | undefined {
    return this.items.value.get(id);
  }

  /** Those that pass, newest last as the server lists them. */
  where(test: (item: T) => boolean): T[] {
    return [...this.items.value.values()].filter(test);
  }

  put(...added: readonly T[]): void {
    const next = new Map(this.items.peek());
    for (const item of added) next.set(item.id, item);
    this.items.value = next;
  }

  /** The complete list of what `belongs`: what is not in it any more is forgotten. */
  replace(belongs: (item: T) => boolean, list: readonly T[]): void {
    const kept = [...this.items.peek().values()].filter((item) => !belongs(item));
    this.items.value = new Map([...kept, ...list].map((item) => [item.id, item]));
  }

  forget(id: string): void {
    const next = new Map(this.items.peek());
    next.delete(id);
    this.items.value = next;
  }
}
