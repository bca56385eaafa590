// The language in use. A further language is a further file of the same shape as en.ts.
import { en } from "./en";

export type Texts = typeof en;

export const t: Texts = en;
