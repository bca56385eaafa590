// What the picture of the arm shows, as the app writes it beside the picture.

const figure = (page) => page.locator("figure.arm3d");

export const canvas = (page) => page.locator("figure.arm3d canvas");

/** Waits until the arm is drawn. */
export async function pictureShown(page) {
  await page.locator('figure.arm3d[data-state="shown"][data-pose]').waitFor();
}

/** The joint angles of the arm in the picture. */
export async function shownPose(page) {
  return (await figure(page).getAttribute("data-pose")).split(" ").map(Number);
}

/** Where the tool is on the screen. */
export async function toolOnScreen(page) {
  const [x, y] = (await figure(page).getAttribute("data-tool-at")).split(" ").map(Number);
  const box = await canvas(page).boundingBox();
  return { x: box.x + x, y: box.y + y };
}
