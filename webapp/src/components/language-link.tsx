// The way to the choice of the language, under the name of the present one.
import { link } from "../router";
import { LANGUAGES, language, t } from "../texts";
import { Icon } from "./icon";

export function LanguageLink() {
  const name = LANGUAGES.find((one) => one.code === language)?.name ?? language;
  return (
    <a class="language-link" href={link({ page: "language" })} aria-label={t.language.link(name)}>
      <Icon name="globe" />
      <span>{name}</span>
    </a>
  );
}
