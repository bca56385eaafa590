// What stands in the way of people who use the app otherwise: by keyboard, with large text, with
// colours of their own, or without motion.
import { findFaults } from "./faults.mjs";
import { drawn } from "./phone.mjs";

/** Text twice as large as the browser's own 16 px, as set in its settings. */
const TWICE = { standard: 32, fixed: 26 };
const ONCE = { standard: 16, fixed: 13 };

/** Everything found, in words. */
export async function barriers(page) {
  const found = [];
  const note = (how, faults) => found.push(...faults.map((fault) => `${how}: ${fault}`));

  // The browser shows the focus ring only to people who press keys.
  await page.keyboard.press("Shift");
  note("by keyboard", await page.evaluate(walkFocus));

  await page.emulateMedia({ reducedMotion: "reduce" });
  note("without motion", await page.evaluate(findMotion));
  await page.emulateMedia({ reducedMotion: null });

  await page.emulateMedia({ forcedColors: "active" });
  note("with own colours", await page.evaluate(findInvisible));
  await page.emulateMedia({ forcedColors: null });

  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Page.setFontSizes", { fontSizes: TWICE });
  await drawn(page);
  note("with large text", await page.evaluate(findFaults, { large: true }));
  note("with large text", await page.evaluate(walkFocus));
  await devtools.send("Page.setFontSizes", { fontSizes: ONCE });
  await devtools.detach();
  return found;
}

/** Runs in the page. Gives each control the focus in the order of the Tab key: it must take it, be
 *  seen, show a ring, and not lie above the one before. Leaves focus and scrolling as they were. */
function walkFocus() {
  const faults = [];
  const before = { focus: document.activeElement, top: document.querySelector("main").scrollTop };
  const page = document.scrollingElement.scrollTop;
  const candidates = [...document.querySelectorAll("button, a[href], summary, input, [tabindex]")];
  const stops = candidates.filter((element) => {
    if (element.tabIndex < 0 || element.disabled) return false;
    if (element.checkVisibility?.({ visibilityProperty: true }) === false) return false;
    // Of radio buttons only the chosen one is a stop; arrow keys lead to the others.
    return element.type !== "radio" || element.checked;
  });
  let last = null;
  for (const element of stops) {
    const name = (element.ariaLabel ?? element.textContent.trim()) || element.value;
    const say = (what) => faults.push(`${element.tagName.toLowerCase()} "${name}" ${what}`);
    if (element.tabIndex > 0) say("jumps the queue");
    element.focus();
    if (document.activeElement !== element) {
      say("does not take the focus");
      continue;
    }
    const shown = element.closest("label") ?? element;
    const rings = [element, shown].map((one) => getComputedStyle(one));
    if (!rings.some((one) => one.outlineStyle !== "none" && parseFloat(one.outlineWidth) >= 3)) {
      say("shows no focus");
    }
    const box = element.getBoundingClientRect();
    const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    if (!at || !(shown.contains(at) || at.contains(element))) say("has the focus out of sight");
    const scrolled =
      document.scrollingElement.scrollTop + (element.closest("main")?.scrollTop ?? 0);
    const placed = box.top + scrolled;
    const place = { part: element.closest("header, main, .actions, .stop-bar"), bottom: placed };
    if (last?.part === place.part && placed + box.height <= last.bottom) say("lies above its turn");
    last = place;
  }
  before.focus?.focus({ preventScroll: true });
  document.querySelector("main").scrollTop = before.top;
  document.scrollingElement.scrollTop = page;
  return faults;
}

/** Runs in the page: what moves although the person asked that nothing does. */
function findMotion() {
  return document
    .getAnimations()
    .filter((one) => one.playState === "running")
    .map((one) => `${one.effect?.target?.className} moves`);
}

/** Runs in the page: what cannot be told apart when all colours are the person's own. */
function findInvisible() {
  const faults = [];
  const bordered = (style) => style.borderTopStyle !== "none" && parseFloat(style.borderTopWidth);
  for (const element of document.querySelectorAll(
    "#app :is(button, a[href], input:not([type=radio], [type=range]), label.choice-card)",
  )) {
    const style = getComputedStyle(element);
    if (element.tabIndex < 0 && element.tagName === "INPUT") continue;
    const underlined = style.textDecorationLine === "underline";
    if (!bordered(style) && !underlined) faults.push(`"${element.textContent}" has no border`);
  }
  const chosen = "[aria-current], [aria-pressed=true], label.choice-card:has(:checked)";
  for (const element of document.querySelectorAll(chosen)) {
    const look = (one) => {
      const { borderTopColor, borderTopWidth, borderTopStyle } = getComputedStyle(one);
      return [borderTopColor, borderTopWidth, borderTopStyle].join(" ");
    };
    const other = [...element.parentElement.children].find((one) => one !== element);
    if (other && look(other) === look(element)) {
      faults.push(`"${element.textContent}" does not look chosen`);
    }
  }
  for (const bar of document.querySelectorAll(".progress-bar")) {
    const colour = (one) => getComputedStyle(one).backgroundColor;
    const drawn = getComputedStyle(bar).backgroundImage !== "none";
    if (!drawn && colour(bar) === colour(bar.parentElement)) faults.push("the progress is unseen");
  }
  return faults;
}
