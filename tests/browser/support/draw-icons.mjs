// Draws the app's icons as PNG files from their SVG: phones take no SVG for the home screen.
// Run it after a change of an SVG (`npm run icons`); the specs check the sizes.
import { readFile, writeFile } from "node:fs/promises";
import { openBrowser } from "./phone.mjs";

const STATIC = new URL("../../../static/", import.meta.url);
const ICONS = [
  { from: "icon.svg", to: "icon-192.png", size: 192 },
  { from: "icon.svg", to: "icon-512.png", size: 512 },
  { from: "icon-maskable.svg", to: "icon-maskable-512.png", size: 512 },
  // Apple rounds the corners by itself and paints what is transparent black.
  { from: "icon-maskable.svg", to: "apple-touch-icon.png", size: 180 },
];

const browser = await openBrowser();
for (const { from, to, size } of ICONS) {
  const svg = await readFile(new URL(from, STATIC), "utf8");
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  const source = `data:image/svg+xml;base64,${Buffer.from(svg).toString("base64")}`;
  await page.setContent(
    `<style>body{margin:0}img{display:block;width:100vw}</style><img src="${source}">`,
  );
  await page.locator("img").evaluate((image) => image.decode());
  await writeFile(new URL(to, STATIC), await page.screenshot({ omitBackground: true }));
  await page.close();
}
await browser.close();
