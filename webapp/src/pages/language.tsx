// The choice of the language: each under its own name, so nobody has to read another one. It is
// open to phones that are not connected yet, too.
import { Icon } from "../components/icon";
import { PhoneName } from "../components/phone-name";
import { Page } from "../components/page";
import { go } from "../state/navigation";
import { chooseLanguage, LANGUAGES, language, t } from "../texts";

/** The word for language, in all of them at once. */
const TITLE = "Language · Sprache · Langue · Lingua";

export function LanguagePage() {
  const choose = (code: string) => {
    go({ page: "teach" }, true);
    chooseLanguage(code);
  };
  return (
    <Page title={TITLE} back={{ page: "teach" }}>
      <ul class="rows">
        {LANGUAGES.map(({ code, name }) => (
          <li key={code}>
            <button
              type="button"
              class="row language-choice"
              lang={code}
              aria-pressed={code === language}
              onClick={() => choose(code)}
            >
              <strong class="row-name">{name}</strong>
              {code === language && <Icon name="check" />}
            </button>
          </li>
        ))}
      </ul>
      <p>{t.language.explain}</p>
      <PhoneName />
    </Page>
  );
}
