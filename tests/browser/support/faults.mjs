// What is wrong with a screen, found in the page itself: sizes, gaps, overlaps, contrast, names.

/** Runs in the page, so it may use nothing from outside itself. With text twice as large the frame
 *  scrolls with the page, and only what is cut off or covered counts. */
export function findFaults({ large = false }) {
  const faults = [];
  const TARGET = 56;
  const GAP = 8;
  const TEXT = 18;
  const CONTRAST = 7;
  const say = (element, what) => {
    const text = (element.getAttribute("aria-label") ?? element.textContent ?? "")
      .trim()
      .slice(0, 40);
    faults.push(`${element.tagName.toLowerCase()}.${element.className} "${text}": ${what}`);
  };
  const shown = (element) => {
    const box = element.getBoundingClientRect();
    const style = getComputedStyle(element);
    // What is folded away has a place, too.
    return (
      element.checkVisibility() &&
      box.width > 1 &&
      box.height > 1 &&
      style.visibility !== "hidden" &&
      style.opacity !== "0"
    );
  };

  const width = document.documentElement.clientWidth;
  const height = document.documentElement.clientHeight;
  for (const element of document.querySelectorAll("#app *")) {
    if (!shown(element) || element.closest(".chart, svg")) continue;
    const box = element.getBoundingClientRect();
    // A table of numbers may be wider than the screen when its text is large: it scrolls alone.
    if (large && element.closest(".numbers")) continue;
    if (box.left < -0.5 || box.right > width + 0.5) say(element, "reaches out of the screen");
    const { overflowX, overflowY } = getComputedStyle(element);
    if (element.matches("input, textarea")) continue;
    if (overflowX !== "visible" && element.scrollWidth > element.clientWidth + 1) {
      say(element, "is cut off at the side");
    }
    const cuts = overflowY === "hidden" || overflowY === "clip";
    if (cuts && element.scrollHeight > element.clientHeight + 1) say(element, "is cut off below");
  }

  const stop = document.querySelector("button.stop").getBoundingClientRect();
  if (stop.bottom > height || stop.top < 0) faults.push("Stop is not on the screen");

  if (document.documentElement.scrollWidth > width) faults.push("the page scrolls sideways");
  if (large) return faults;

  const main = document.querySelector("main").getBoundingClientRect();
  if (main.height < 120) faults.push(`only ${main.height} px are left for the content`);

  // A radio button counts as large as the label around it.
  const controls = [
    ...document.querySelectorAll(
      "button, a[href], summary, input, select, textarea, label.choice-card",
    ),
  ].filter((element) => shown(element) && element.type !== "radio");
  for (const element of controls) {
    const box = element.getBoundingClientRect();
    if (box.height < TARGET - 0.5 || box.width < TARGET - 0.5) {
      say(element, `is a target of ${Math.round(box.width)} x ${Math.round(box.height)}`);
    }
    const named =
      element.getAttribute("aria-label") ?? (element.labels?.[0] ?? element).textContent;
    if (named.trim() === "") say(element, "has no name");
  }
  for (const [index, one] of controls.entries()) {
    for (const other of controls.slice(index + 1)) {
      if (one.contains(other) || other.contains(one)) continue;
      // Controls scrolled under the frame are covered by it, not next to it.
      if (Boolean(one.closest("main")) !== Boolean(other.closest("main"))) continue;
      const a = one.getBoundingClientRect();
      const b = other.getBoundingClientRect();
      const across = Math.max(a.left, b.left) - Math.min(a.right, b.right);
      const down = Math.max(a.top, b.top) - Math.min(a.bottom, b.bottom);
      const apart = Math.max(across, down);
      if (apart < GAP - 0.5)
        say(one, `is ${Math.round(apart)} px from "${other.textContent.trim()}"`);
    }
  }

  const channels = (colour) => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const light = (colour) => {
    const [r, g, b] = colour.map((value) => {
      const part = value / 255;
      return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (element) => {
    for (let one = element; one; one = one.parentElement) {
      const [r, g, b, alpha = 1] = channels(getComputedStyle(one).backgroundColor);
      if (alpha === 1) return [r, g, b];
    }
    return [255, 255, 255];
  };
  const walker = document.createTreeWalker(document.getElementById("app"), NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (walker.currentNode.data.trim() === "" || !shown(element)) continue;
    const style = getComputedStyle(element);
    if (Number.parseFloat(style.fontSize) < TEXT) say(element, `text of ${style.fontSize}`);
    const [a, b] = [light(channels(style.color).slice(0, 3)), light(ground(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < CONTRAST) say(element, `contrast ${contrast.toFixed(1)}`);
  }
  return faults;
}
