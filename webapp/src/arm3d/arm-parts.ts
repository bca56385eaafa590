// What the arm looks like: rounded bodies of our own around its joints, one list for each part that
// moves by itself. The proportions are those of a small collaborative arm; only the joints' places,
// which come from the kinematic chain, are exact.
import { barrel, laid, lathe, link, type Solid } from "./solids";

export type Surface = "body" | "joint" | "metal" | "mark";

export interface Part {
  surface: Surface;
  solid: Solid;
}

const body = (solid: Solid): Part => ({ surface: "body", solid });
const joint = (solid: Solid): Part => ({ surface: "joint", solid });
const metal = (solid: Solid): Part => ({ surface: "metal", solid });

/** The base, then the part that each joint turns, in the frame of that joint. */
export const ARM_PARTS: readonly (readonly Part[])[] = [
  [
    body(
      lathe([
        [0, 0],
        [102, 0, 5],
        [102, 20, 8],
        [80, 46, 40],
        [78, 136, 8],
        [0, 136],
      ]),
    ),
    joint(barrel(73, 130, 146, 3)),
  ],
  [
    body(barrel(80, -121, 40, 14)),
    body(laid(barrel(80, -86, 46, 24), "about y")),
    joint(laid(barrel(54, -90, -80, 4), "about y")),
    joint(laid(barrel(73, 40, 58, 3), "about y")),
  ],
  [
    body(laid(link(79, 66, 444, 84, 26), "about y", [0, 96, 0])),
    joint(laid(barrel(50, 130, 142, 4), "about y")),
    joint(laid(barrel(42, 130, 142, 4), "about y", [0, 0, 444])),
  ],
  [
    joint(laid(barrel(60, 40, 58, 3), "about y")),
    body(laid(link(66, 60, 110, 96, 34), "about y", [0, -2, 0])),
    body(laid(barrel(56, -72, 90, 20), "about x", [0, 0, 110])),
    joint(laid(barrel(36, -76, -66, 4), "about x", [0, 0, 110])),
    joint(laid(barrel(49, 84, 102, 3), "about x", [0, 0, 110])),
  ],
  [
    body(
      laid(
        lathe([
          [0, 98],
          [54, 98, 10],
          [53, 190, 60],
          [43, 400, 40],
          [43, 424, 22],
          [0, 424],
        ]),
        "about x",
      ),
    ),
    body(laid(link(42, 46, 120, 50, 20), "along x, flat in y", [350, -21, 0])),
    joint(laid(barrel(30, -50, -40, 4), "about y", [470, 0, 0])),
    joint(laid(barrel(41, 0, 14, 3), "about y", [470, 0, 0])),
  ],
  [
    body(laid(link(46, 44, 80, 42, 18), "about y", [0, 31, 0])),
    body(laid(barrel(45, -46, 76, 18), "about x", [0, 0, 80])),
    joint(laid(barrel(28, -50, -42, 4), "about x", [0, 0, 80])),
    joint(laid(barrel(39, 70, 84, 3), "about x", [0, 0, 80])),
  ],
  [
    metal(laid(barrel(36, -19, 0, 3), "about x")),
    joint(laid(barrel(14, -4, 0.6, 0.3), "about x")),
    // A mark on the flange shows how far the last joint is turned.
    { surface: "mark", solid: laid(barrel(6, -20, 0.8, 0.4), "about x", [0, 0, 27]) },
  ],
];
