import { Color, Group, PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderer, WebGLRenderTarget } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { dispose } from "./dispose";
import type { Contact } from "./contacts";
import type { Extent } from "./extent";
import { makeMotion, type Motion } from "./frames";
import { Ground } from "./ground";
import { Marks, overlaps, pressing, type Shown } from "./marks";
import type { MotionEvent } from "./run";
import { overlayColors, rgb } from "./colors";
import type { Vec } from "./header";
import { Lines } from "./overlays";
import { Shapes } from "./shapes";
import { Sight } from "./sight";
import type { FrameSource } from "./source";
import { Sun, type ShadowQuality } from "./sun";

/** How the picture is drawn, from the best way to the quickest: part of the screen's resolution, and shadows. */
const qualities: { ratio: number; shadows: ShadowQuality }[] = [
  { ratio: 1, shadows: "soft" }, { ratio: 1, shadows: "hard" }, { ratio: 0.75, shadows: "hard" }, { ratio: 0.5, shadows: "coarse" }, { ratio: 0.5, shadows: "none" },
];
/** What hides bodies is looked for this often while they move [ms]. */
const glassPause = 120;

export interface Ray {
  from: Vec;
  direction: Vec;
  /** Where the camera looks. */
  forward: Vec;
}

/** The scene at a moment, and the camera. */
export class View3D {
  readonly canvas: HTMLCanvasElement;
  motion!: Motion;
  /** Body that the camera goes along with, or -1. */
  followed = -1;
  onChange: () => void = () => {};
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(40, 0, 0.01, 1000);
  private readonly controls: OrbitControls;
  /** What belongs to the runs that are shown. */
  private content = new Group();
  private shapes!: Shapes;
  private ghostShapes: Shapes | undefined;
  private ghostMotion: Motion | undefined;
  private ground!: Ground;
  private marks!: Marks;
  private theme: [string, string, string] | undefined;
  private readonly line = new Lines();
  private readonly pixel = { value: 0.001 };
  private readonly ratio = { value: 1 };
  private readonly up: Vector3;
  private readonly followedAt = new Vector3();
  private sun!: Sun;
  private sight!: Sight;
  private glass: ReadonlySet<string> = new Set();
  private glassAt = -Infinity;
  private glassTimer: ReturnType<typeof setTimeout> | undefined;
  private slowness = 0;
  private quality = 0;
  /** Force of the hottest colour [N], while forces are shown as colours. */
  hottest = 0;

  constructor(container: HTMLElement, private source: FrameSource, private ghost: FrameSource | undefined, private extent: Extent, private ghostColor?: string) {
    this.renderer = new WebGLRenderer({ antialias: true, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = "srgb-linear";
    this.canvas = this.renderer.domElement;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The scene. Drag to turn, scroll to come closer, click a body to see its numbers.");
    container.append(this.canvas);

    const g = new Vector3(...source.header.gravity);
    this.up = g.length() > 0 ? g.clone().normalize().negate() : new Vector3(0, 0, 1);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.onChange());

    this.sun = new Sun(this.up);
    this.scene.add(this.line.lines);
    this.build(source.times[0]);
  }

  /** Shows these runs from now on, at that time [s]; the camera stays where it is in the world. */
  setRuns(source: FrameSource, ghost: FrameSource | undefined, extent: Extent, time: number, ghostColor: string): void {
    const shift = new Vector3(...this.source.header.origin).sub(new Vector3(...source.header.origin));
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.controls.update();
    this.followed = -1;
    this.source = source;
    this.ghost = ghost;
    this.extent = extent;
    this.ghostColor = ghostColor;
    this.content.removeFromParent();
    dispose(this.content);
    this.sun.scene.clear();
    dispose(this.shapes.shadows);
    this.build(time);
  }

  private build(time: number): void {
    const { source, ghost, extent } = this;
    const { header } = source;
    this.content = new Group();
    this.scene.add(this.content);
    this.motion = makeMotion(header.bodies.length);
    this.sun.fit(extent);
    this.sight = new Sight(source);
    this.glassAt = -Infinity;
    this.shapes = new Shapes(header, source.meshes, this.sun.uniforms, { isGhost: false, offset: [0, 0, 0] });
    this.sun.scene.add(this.shapes.shadows);
    this.ground = new Ground(header, new Vector3(...extent.center), extent.radius, this.sun.uniforms, [0, 0, 0]);
    this.marks = new Marks(source, extent.radius, this.pixel, this.ratio);
    this.content.add(this.ground.group, this.shapes.group);
    this.content.add(this.marks.trails.lines, this.marks.links.lines, this.marks.arrows.mesh, this.marks.ring.points, this.marks.dots.points);
    this.ghostShapes = undefined;
    if (ghost) {
      const offset = ghost.header.origin.map((x, c) => x - header.origin[c]) as [number, number, number];
      this.ghostMotion = makeMotion(ghost.header.bodies.length);
      this.ghostShapes = new Shapes(ghost.header, ghost.meshes, this.sun.uniforms, { isGhost: true, offset, tint: this.ghostColor });
      this.content.add(this.ghostShapes.group);
    }

    source.sample(time, this.motion);
    this.ground.update(this.motion);
    if (this.theme) this.setTheme(...this.theme);
  }

  /** Looks at the whole scene again. */
  fit(): void {
    const { direction, distance } = this.bestView();
    this.controls.target.set(...this.extent.center);
    this.camera.position.copy(this.controls.target).addScaledVector(direction, distance);
    this.camera.near = distance / 500;
    this.camera.far = distance * 60;
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = distance / 200;
    this.controls.maxDistance = distance * 20;
    this.controls.update();
  }

  /**
   * From where all of it is seen: from the front, unless it is much larger in the picture from elsewhere, or something that stands still
   * hides more of it.
   */
  private bestView(): { direction: Vector3; distance: number } {
    const front = (Math.abs(this.up.z) > 0.7 ? new Vector3(0.35, -1, 0) : new Vector3(0.35, 0.2, 1)).projectOnPlane(this.up).normalize();
    const center = new Vector3(...this.extent.center);
    const views = [0, 1, -1, 2, -2, 3, -3, 4].flatMap((turn) => [0.42, 0.8, 1.5].map((height) => {
      const direction = front.clone().applyAxisAngle(this.up, (turn * Math.PI) / 4).addScaledVector(this.up, height).normalize();
      const distance = this.distanceToSeeAll(direction);
      return { direction, distance, cost: 0.07 * Math.abs(turn) + 0.2 * (height - 0.42), eye: center.clone().addScaledVector(direction, distance).toArray() };
    }));
    const nearest = Math.min(...views.map(({ distance }) => distance));
    const costs = views.map(({ distance, cost, eye }) => cost + 0.5 * (distance / nearest - 1) + 2 * this.sight.blocked(eye));
    return views[costs.indexOf(Math.min(...costs))];
  }

  /** How far from the middle, in this direction, all corners of the scene's box are just inside the picture. */
  private distanceToSeeAll(direction: Vector3): number {
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const side = new Vector3().crossVectors(this.up, direction).normalize();
    const top = new Vector3().crossVectors(direction, side);
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const arm = new Vector3(...this.extent.half.map((h, c) => (corner & (1 << c) ? h : -h)));
      const wide = Math.abs(arm.dot(side)) / this.camera.aspect, high = Math.abs(arm.dot(top));
      distance = Math.max(distance, Math.max(wide, high) / tangent + arm.dot(direction));
    }
    return 1.12 * distance;
  }

  setTheme(background: string, ground: string, line: string): void {
    this.theme = [background, ground, line];
    this.scene.background = new Color().setStyle(background, "");
    this.ground.setColors(ground, line);
  }

  /** Fits the drawing to its frame; the first time also the camera to the scene. */
  resize(width: number, height: number): void {
    const isFirst = this.camera.aspect === 0;
    const ratio = Math.min(window.devicePixelRatio, 2) * qualities[this.quality].ratio;
    this.ratio.value = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (isFirst) this.fit();
    this.pixel.value = (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / height;
  }

  /** Draws the moment. `flagged` bodies are marked like those that overlap. */
  draw(time: number, shown: Shown, selected: number, event: MotionEvent | undefined, flagged: number[]): void {
    this.source.sample(time, this.motion);
    this.shapes.update(this.motion);
    this.ground.update(this.motion);
    this.follow();
    const contacts = shown.contacts || shown.penetration || shown.heat ? this.source.contactsAt(time) : [];
    const deep = shown.penetration ? overlaps(contacts, this.source) : [];
    const overlapping = deep.flatMap(({ bodyA, bodyB }) => [bodyA, bodyB]);
    this.shapes.mark({ selected, overlapping: new Set([...overlapping, ...flagged]), glass: this.glassNow(), heat: shown.heat ? this.heatOf(contacts) : undefined });
    this.sun.setQuality(shown.shadows ? qualities[this.quality].shadows : "none");
    this.marks.update(time, this.motion, contacts, shown, selected, event);
    if (this.ghostShapes && this.ghost && this.ghostMotion) {
      this.ghostShapes.group.visible = shown.ghost;
      if (shown.ghost) {
        this.ghost.sample(time, this.ghostMotion);
        this.ghostShapes.update(this.ghostMotion);
      }
    }
    this.sun.draw(this.renderer);
    this.renderer.render(this.scene, this.camera);
  }

  /** The standing shapes between the camera and the moving bodies. */
  private glassNow(): ReadonlySet<string> {
    const now = performance.now();
    if (this.sight.isOpen) return this.glass;
    if (now - this.glassAt < glassPause) {
      // What was not looked for now is looked for soon.
      this.glassTimer ??= setTimeout(() => ((this.glassTimer = undefined), this.onChange()), glassPause);
      return this.glass;
    }
    this.glassAt = now;
    this.glass = this.sight.hiding(this.camera.position.toArray(), this.motion);
    return this.glass;
  }

  /** How hard each dynamic body is pressed, from 0 to 1; -1 what does not move. */
  private heatOf(contacts: Contact[]): Float32Array {
    const { bodies } = this.source.header;
    const { forces, hottest } = pressing(bodies.length, contacts);
    this.hottest = hottest;
    return forces.map((force, i) => (bodies[i].motion !== "dynamic" ? -1 : hottest > 0 ? Math.min(0.999, Math.sqrt(force / hottest)) : 0));
  }

  /** The body under a point of the canvas (CSS pixels), or -1; what stands between it and the eye is looked through if only what moves is asked for. */
  pick(x: number, y: number, what: "all" | "moving" = "all"): number {
    const size = this.renderer.getSize(new Vector2());
    const target = new WebGLRenderTarget(1, 1);
    const background = this.scene.background;
    const hidden = [this.ground.group, this.marks.trails.lines, this.marks.links.lines, this.marks.arrows.mesh, this.marks.ring.points, this.marks.dots.points, this.ghostShapes?.group];
    const visible = hidden.map((object) => object?.visible);
    hidden.forEach((object) => object && (object.visible = false));
    this.shapes.setPicking(what);
    this.scene.background = null;
    this.camera.setViewOffset(size.x, size.y, x, y, 1, 1);
    this.renderer.setRenderTarget(target);
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.clear();
    this.renderer.render(this.scene, this.camera);
    const bytes = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(target, 0, 0, 1, 1, bytes);
    this.renderer.setRenderTarget(null);
    this.camera.clearViewOffset();
    this.shapes.setPicking("none");
    this.scene.background = background;
    hidden.forEach((object, i) => object && (object.visible = visible[i] ?? true));
    target.dispose();
    return bytes[0] + 256 * bytes[1] + 65536 * bytes[2] - 1;
  }

  /** The line of sight through a point of the canvas (CSS pixels), from Header.origin [m]; direction of length 1. */
  rayAt(x: number, y: number): Ray {
    const size = this.renderer.getSize(new Vector2());
    const to = new Vector3((2 * x) / size.x - 1, 1 - (2 * y) / size.y, 0.5).unproject(this.camera);
    const from = this.camera.position;
    return { from: from.toArray(), direction: to.sub(from).normalize().toArray(), forward: this.camera.getWorldDirection(new Vector3()).toArray() };
  }

  /** Whether dragging turns the camera. */
  set canTurn(can: boolean) {
    this.controls.enabled = can;
  }

  /** A line between two points, from Header.origin; none without them. */
  showLine(ends: [ArrayLike<number>, ArrayLike<number>] | undefined): void {
    this.line.clear();
    if (ends) this.line.add(ends[0], ends[1], rgb(overlayColors.impulse));
    this.line.commit();
  }

  /** Takes the camera along with a body from now on (-1: leaves it where it is). */
  startFollowing(body: number): void {
    this.followed = body;
    if (body < 0) return;
    this.followedAt.fromArray(this.motion.position, 3 * body);
    const shift = this.followedAt.clone().sub(this.controls.target);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.controls.update();
  }

  /** Takes note of how long a frame took while playing [s]; when a dozen are too long for 30 a second, draws in a quicker way. */
  noteFrameTime(seconds: number): boolean {
    this.slowness = seconds > 1 / 30 ? this.slowness + Math.min(6, 30 * seconds) : Math.max(0, this.slowness - 2);
    if (this.slowness < 18 || this.quality === qualities.length - 1) return false;
    this.slowness = 0;
    ++this.quality;
    return true;
  }

  /** Part of the screen's resolution that is drawn at. */
  get resolution(): number {
    return qualities[this.quality].ratio;
  }

  private follow(): void {
    if (this.followed < 0) return;
    const now = new Vector3().fromArray(this.motion.position, 3 * this.followed);
    const shift = now.clone().sub(this.followedAt);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.followedAt.copy(now);
    this.camera.lookAt(this.controls.target);
  }
}
