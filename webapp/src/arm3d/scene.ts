// The drawing itself: everything that needs three.js, which is why this file is only loaded where
// an arm is shown. Draws when it is told to, never by itself.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  FrontSide,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  TorusGeometry,
  Vector3,
  WebGLRenderer,
  type Material,
} from "three";
import { ARM_PARTS, type Surface } from "./arm-parts";
import { CHAIN, RADIANS } from "./kinematics";
import type { Pose } from "./poses";
import { together } from "./solids";
import { tube, type Tube } from "./tube";
import type { Vec3 } from "./vector";
import { eye, FIELD_DEG, type Size, type Viewpoint } from "./viewpoint";

/** Colours by what they are for, as the style sheet names them. */
export type Palette = Record<
  Surface | "ground" | "grid" | "shadow" | "ghost" | "path" | "quiet" | "band" | "handle",
  string
>;

const GRID_CELL_MM = 100;
const GRID_CELLS = 11;
const SHADOW_FALL = { x: 0.22, y: 0.16 };
/** Finer than this nobody sees on a phone, and it costs its square. */
const FINEST = 2;

export class ArmScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 50, 20_000);
  private readonly paints = makePaints();
  private readonly arm: Arm;
  private readonly ghostArm: Arm;
  private readonly shadow: Arm;
  private readonly lines = new Group();
  /** A ball that shows what is in it, with a rim that always faces the eye. */
  private readonly handle = new Group();
  private readonly plumb: LineSegments;
  private grid: LineSegments | null = null;

  /** Throws where there is no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    const parts = armGeometries();
    const { paints } = this;
    this.arm = new Arm(parts, [(surface) => paints[surface]]);
    this.shadow = new Arm(parts, [() => paints.shadow]);
    // First only its depth, then its colour: what lies behind its front does not shine through.
    // Its base would only lie in the base that is drawn anyway.
    this.ghostArm = new Arm([[], ...parts.slice(1)], [() => paints.ghostDepth, () => paints.ghost]);
    this.ghostArm.root.visible = false;
    this.shadow.root.matrixAutoUpdate = false;
    this.shadow.root.matrix.copy(flattened());
    this.handle.add(
      withOrder(new Mesh(new SphereGeometry(0.94, 32, 20), paints.handle), 4),
      withOrder(new Mesh(new TorusGeometry(0.94, 0.06, 10, 48), paints.rim), 5),
    );
    this.handle.visible = false;
    const ends = new BufferGeometry();
    ends.setAttribute("position", new BufferAttribute(new Float32Array(12), 3));
    this.plumb = new LineSegments(ends, paints.plumb);
    this.plumb.visible = this.plumb.frustumCulled = false;
    const key = new DirectionalLight(0xffffff, 1.5);
    key.position.set(-900, 1500, 1300);
    this.camera.add(key);
    this.camera.up.set(0, 0, 1);
    const sky = new HemisphereLight(0xffffff, 0x9aa3ad, 1.9);
    sky.position.set(0, 0, 1);
    this.scene.add(this.camera, sky, this.arm.root, this.shadow.root, this.ghostArm.root);
    this.scene.add(this.lines, this.handle, this.plumb);
  }

  /** Settles when the graphics are prepared, so that the first drawing keeps nobody waiting. */
  async prepare(): Promise<void> {
    await this.renderer.compileAsync(this.scene, this.camera);
  }

  setSize({ width, height }: Size, pixelRatio: number): void {
    this.renderer.setPixelRatio(Math.min(FINEST, pixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  setPalette(palette: Palette): void {
    const { paints } = this;
    for (const name of ["body", "joint", "metal", "mark", "shadow", "ghost", "path"] as const) {
      paints[name].color.set(palette[name]);
    }
    for (const name of ["quiet", "band", "handle"] as const) paints[name].color.set(palette[name]);
    paints.rim.color.set(palette.handle);
    paints.plumb.color.set(palette.handle);
    this.renderer.setClearColor(palette.ground);
    if (this.grid) {
      this.scene.remove(this.grid);
      this.grid.geometry.dispose();
    }
    this.grid = makeGrid(new Color(palette.ground), new Color(palette.grid), paints.grid);
    this.scene.add(this.grid);
  }

  setPose(pose: Pose): void {
    this.arm.setPose(pose);
    this.shadow.setPose(pose);
  }

  setGhost(pose: Pose | null): void {
    this.ghostArm.root.visible = pose !== null;
    if (pose) this.ghostArm.setPose(pose);
  }

  /** Takes the place of all lines drawn before. */
  setLines(lines: readonly Line[]): void {
    for (const mesh of [...this.lines.children]) {
      this.lines.remove(mesh);
      if (mesh instanceof Mesh) (mesh.geometry as BufferGeometry).dispose();
    }
    for (const { look, placesMm, radiusMm } of lines) {
      if (placesMm.length < 2) continue;
      const geometry = geometryOf(tube(placesMm, radiusMm, look === "band" ? 16 : 8));
      if (look === "band") this.lines.add(withOrder(new Mesh(geometry, this.paints.bandDepth), 1));
      this.lines.add(withOrder(new Mesh(geometry, this.paints[look]), look === "band" ? 2 : 0));
    }
  }

  /** The ball that a finger takes hold of; null where there is none. */
  setHandle(handle: { placeMm: Vec3; radiusMm: number; toolMm: Vec3 } | null): void {
    this.handle.visible = this.plumb.visible = handle !== null;
    if (!handle) return;
    this.handle.position.set(...handle.placeMm);
    this.handle.scale.setScalar(handle.radiusMm);
    const [x, y] = handle.placeMm;
    const ends = this.plumb.geometry.getAttribute("position");
    ends.array.set([...handle.placeMm, x, y, 0, ...handle.placeMm, ...handle.toolMm]);
    ends.needsUpdate = true;
  }

  draw(view: Viewpoint): void {
    const { placeMm } = eye(view);
    this.camera.position.set(...placeMm);
    this.camera.lookAt(new Vector3(...view.centreMm));
    this.handle.quaternion.copy(this.camera.quaternion);
    this.renderer.render(this.scene, this.camera);
  }

  /** Gives the graphics memory back; the drawing is of no use afterwards. */
  dispose(): void {
    this.scene.traverse((object) => {
      if (object instanceof Mesh || object instanceof LineSegments) {
        (object.geometry as BufferGeometry).dispose();
      }
    });
    for (const paint of Object.values(this.paints)) paint.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

export interface Line {
  look: "path" | "quiet" | "band";
  placesMm: readonly Vec3[];
  radiusMm: (point: number) => number;
}

function makePaints() {
  const solid = (roughness: number, metalness = 0) =>
    new MeshStandardMaterial({ roughness, metalness });
  const glass = (opacity: number) =>
    new MeshStandardMaterial({ roughness: 0.7, transparent: true, opacity, side: FrontSide });
  // A little behind, so that an arm standing in its own ghost is not speckled by it.
  const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1000 };
  const depthOnly = (offset: object) =>
    new MeshBasicMaterial({ colorWrite: false, transparent: true, ...offset });
  const ghost = glass(0.38);
  Object.assign(ghost, behind);
  return {
    body: solid(0.42),
    joint: solid(0.5),
    metal: solid(0.35, 0.35),
    mark: solid(0.5),
    shadow: new MeshBasicMaterial(),
    ghost,
    ghostDepth: depthOnly(behind),
    path: solid(0.6),
    quiet: solid(0.6),
    band: glass(0.3),
    bandDepth: depthOnly({}),
    handle: glass(0.3),
    // Also where the arm is in front of it: what is to be taken hold of is always seen.
    rim: new MeshBasicMaterial({ transparent: true, opacity: 0.95, depthTest: false }),
    plumb: new LineBasicMaterial({ transparent: true, opacity: 0.7 }),
    grid: new LineBasicMaterial({ vertexColors: true }),
  };
}

type Parts = readonly { surface: Surface; geometry: BufferGeometry }[][];

/** One body for each part of the arm and each surface on it, put together once. */
const BODIES = ARM_PARTS.map((parts) =>
  [...new Set(parts.map((part) => part.surface))].map((surface) => {
    const same = parts.filter((part) => part.surface === surface);
    return { surface, solid: together(same.map((part) => part.solid)) };
  }),
);

function armGeometries(): Parts {
  return BODIES.map((parts) =>
    parts.map(({ surface, solid }) => ({ surface, geometry: geometryOf(solid) })),
  );
}

/** The parts hung on one another. */
class Arm {
  readonly root = new Group();
  private readonly joints: Group[];

  constructor(parts: Parts, coats: readonly ((surface: Surface) => Material)[]) {
    let holder = this.root;
    dress(holder, parts[0]!, coats);
    this.joints = CHAIN.map(({ offsetMm }, joint) => {
      const moved = new Group();
      moved.position.set(...offsetMm);
      dress(moved, parts[joint + 1]!, coats);
      holder.add(moved);
      holder = moved;
      return moved;
    });
  }

  setPose(pose: Pose): void {
    this.joints.forEach((moved, joint) => {
      const [x, y, z] = CHAIN[joint]!.axis;
      const by = (pose[joint] ?? 0) * RADIANS;
      moved.rotation.set(x * by, y * by, z * by);
    });
  }
}

function dress(
  holder: Group,
  parts: Parts[number],
  coats: readonly ((surface: Surface) => Material)[],
): void {
  for (const { surface, geometry } of parts) {
    coats.forEach((coat, order) => {
      // With two coats the first is all drawn before the second.
      const mesh = withOrder(new Mesh(geometry, coat(surface)), coats.length > 1 ? order + 1 : 0);
      mesh.frustumCulled = false;
      holder.add(mesh);
    });
  }
}

function withOrder(mesh: Mesh, order: number): Mesh {
  mesh.renderOrder = order;
  return mesh;
}

function geometryOf(shape: Tube | { positions: number[]; normals: number[]; indices: number[] }) {
  const geometry = new BufferGeometry();
  const attribute = (values: ArrayLike<number>) => new BufferAttribute(new Float32Array(values), 3);
  geometry.setAttribute("position", attribute(shape.positions));
  geometry.setAttribute("normal", attribute(shape.normals));
  geometry.setIndex(shape.indices);
  return geometry;
}

/** Everything laid flat on the floor along the light: a shadow without a shadow map. Just under
 *  the floor, so that the grid is drawn over it. */
function flattened(): Matrix4 {
  const { x, y } = SHADOW_FALL;
  return new Matrix4().set(1, 0, x, 0, 0, 1, y, 0, 0, 0, 0.001, -2, 0, 0, 0, 1);
}

/** Squares on the floor that fade into the ground towards their edge. */
function makeGrid(ground: Color, line: Color, paint: LineBasicMaterial): LineSegments {
  const [positions, colours]: [number[], number[]] = [[], []];
  const reach = GRID_CELLS * GRID_CELL_MM;
  const corner = (x: number, y: number) => {
    const shade = line.clone().lerp(ground, Math.min(1, (Math.hypot(x, y) / reach) ** 1.5));
    positions.push(x, y, 0);
    colours.push(shade.r, shade.g, shade.b);
  };
  for (let across = -GRID_CELLS; across <= GRID_CELLS; across += 1) {
    for (let along = -GRID_CELLS; along < GRID_CELLS; along += 1) {
      const [a, b, c] = [across, along, along + 1].map((cells) => cells * GRID_CELL_MM) as [
        number,
        number,
        number,
      ];
      if (Math.hypot(a, b) > reach || Math.hypot(a, c) > reach) continue;
      corner(a, b);
      corner(a, c);
      corner(b, a);
      corner(c, a);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
  return new LineSegments(geometry, paint);
}
