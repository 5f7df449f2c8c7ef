import type { Motion } from "./frames";
import { shapesOf, type Vec } from "./header";
import type { LiveCommand } from "./live_message";
import { add, orientationAt, turned, vectorAt } from "./marks";
import { distanceToShapes } from "./ray_cast";
import type { FrameSource } from "./source";
import type { Ray, View3D } from "./view3d";

/** What dragging in the scene does: to grab is to pull what can move, and to turn the camera anywhere else. */
export type Tool = "grab" | "turn" | "hit";

/** A pointer that has moved less has clicked [CSS pixels]. */
const clickReach = 4;

interface Grip {
  body: number;
  /** In the body frame [m]. */
  point: Vec;
  /** From Header.origin [m]. */
  target: Vec;
  /** Of the plane that the target moves in. */
  normal: Vec;
}

const scaled = (v: Vec, s: number): Vec => [v[0] * s, v[1] * s, v[2] * s];
const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The point of a ray that is nearest to another point. */
export function nearestOnRay(ray: Ray, to: Vec): Vec {
  return add(ray.from, scaled(ray.direction, dot(minus(to, ray.from), ray.direction)));
}

/** Where a ray meets the plane through a point; undefined where it runs along it or away from it. */
export function onPlane(ray: Ray, point: Vec, normal: Vec): Vec | undefined {
  const along = dot(ray.direction, normal);
  const distance = dot(minus(point, ray.from), normal) / along;
  return Number.isFinite(distance) && distance > 0 ? add(ray.from, scaled(ray.direction, distance)) : undefined;
}

/** A point from Header.origin in the frame of a body. */
export function inBody(motion: Motion, body: number, point: Vec): Vec {
  const [w, x, y, z] = orientationAt(motion, body);
  return turned([w, -x, -y, -z], minus(point, vectorAt(motion.position, body)));
}

/** Pulls and hits bodies with the pointer. */
export class LiveTools {
  tool: Tool = "grab";
  /** Change of speed that a hit gives [m/s]. */
  hitSpeed = 2;
  private grip: Grip | undefined;
  /** What was pressed and is not pulled yet, and where [CSS pixels]. */
  private pressed: { grip: Grip; x: number; y: number } | undefined;
  private isTold = true;

  constructor(private readonly stage: HTMLElement, private readonly view: View3D, private readonly source: FrameSource, private readonly send: (command: LiveCommand) => void, private readonly select: (body: number) => void) {
    // Before the camera's controls see it.
    stage.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    stage.addEventListener("pointermove", (event) => this.move(event));
    stage.addEventListener("pointerup", () => {
      // The stage has captured the pointer, and with it the click.
      if (this.pressed) this.select(this.pressed.grip.body);
      this.release();
    });
    stage.addEventListener("pointercancel", () => this.release());
  }

  /** Draws the pull, and tells the simulation of the newest target: once a picture, not once a move. */
  update(): void {
    const grip = this.grip;
    if (!grip) return;
    const { motion } = this.view;
    const held = add(vectorAt(motion.position, grip.body), turned(orientationAt(motion, grip.body), grip.point));
    this.view.showLine([held, grip.target]);
    if (this.isTold) return;
    this.isTold = true;
    this.send({ do: "pull", body: grip.body, point: grip.point, target: add(grip.target, this.source.header.origin) });
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    const tool = event.shiftKey ? "grab" : event.altKey ? "hit" : this.tool;
    if (tool === "turn") return;
    const [x, y] = this.placeOf(event);
    // What stands in front is no obstacle to the hand.
    const body = this.view.pick(x, y, "moving");
    if (body < 0 || this.source.header.bodies[body].motion !== "dynamic") return;
    const ray = this.view.rayAt(x, y);
    const place = this.surfacePoint(ray, body);
    const point = inBody(this.view.motion, body, place);
    this.view.canTurn = false;
    if (tool === "hit") {
      this.send({ do: "push", body, point, impulse: scaled(ray.direction, this.source.header.bodies[body].mass * this.hitSpeed) });
      return;
    }
    this.pressed = { grip: { body, point, target: place, normal: ray.forward }, x: event.clientX, y: event.clientY };
    this.stage.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const { pressed } = this;
    if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > clickReach) {
      // The body may have moved on since.
      this.grip = pressed.grip;
      this.pressed = undefined;
    }
    if (!this.grip) return;
    const target = onPlane(this.view.rayAt(...this.placeOf(event)), this.grip.target, this.grip.normal);
    if (!target) return;
    this.grip.target = target;
    this.isTold = false;
  }

  private release(): void {
    this.view.canTurn = true;
    this.pressed = undefined;
    if (!this.grip) return;
    this.grip = undefined;
    this.view.showLine(undefined);
    this.send({ do: "release" });
  }

  /** Where a line of sight meets the body; at its very edge, where it may pass, the point of the line nearest to the middle. */
  private surfacePoint(ray: Ray, body: number): Vec {
    const { motion } = this.view;
    const [w, x, y, z] = orientationAt(motion, body);
    const line = { from: inBody(motion, body, ray.from), direction: turned([w, -x, -y, -z], ray.direction) };
    const distance = distanceToShapes(line, shapesOf(this.source.header, body), this.source.meshes);
    return distance === undefined ? nearestOnRay(ray, vectorAt(motion.position, body)) : add(ray.from, scaled(ray.direction, distance));
  }

  private placeOf(event: PointerEvent): [number, number] {
    const box = this.view.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}
