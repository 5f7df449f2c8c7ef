import { makeMotion, type Motion } from "./frames";
import { shapesOf, type ShapeHeader, type Vec } from "./header";
import { orientationAt, turned, vectorAt } from "./marks";
import { distanceToShapes } from "./ray_cast";
import type { FrameSource } from "./source";

interface Obstacle {
  body: number;
  index: number;
  shape: ShapeHeader;
}

/** More sight lines than these through shapes are not looked at. */
const mostTests = 6000;
const mostTargets = 32;

/** Names a shape of a body among all that are drawn. */
export const shapeName = (body: number, index: number): string => `${body} ${index}`;

/** What stands between an eye and the bodies that move. */
export class Sight {
  private readonly obstacles: Obstacle[];
  private readonly planes: Obstacle[];
  private readonly targets: number[];
  private readonly start: Motion;
  private readonly samples: Motion[];

  constructor(private readonly source: FrameSource) {
    const { header, moving, times } = source;
    const standing = header.bodies.flatMap(({ motion }, body) => (motion === "static" ? shapesOf(header, body).map((shape, index) => ({ body, index, shape })) : []));
    this.obstacles = standing.filter(({ shape }) => shape.type !== "plane").slice(0, mostTests / 8);
    this.planes = standing.filter(({ shape }) => shape.type === "plane");
    const count = Math.max(8, Math.min(mostTargets, Math.floor(mostTests / Math.max(1, this.obstacles.length))));
    const stride = Math.max(1, Math.ceil(moving.length / count));
    this.targets = moving.filter((_, i) => i % stride === 0);
    this.samples = [0, 0.35, 0.7, 1].map((part) => {
      const motion = makeMotion(header.bodies.length);
      source.sample(times[0] + part * (times[times.length - 1] - times[0]), motion);
      return motion;
    });
    this.start = this.samples[0];
  }

  /** The shapes that hide more than a few of the moving bodies from this eye (from Header.origin) at this moment. */
  hiding(eye: Vec, motion: Motion): Set<string> {
    const least = Math.max(1, 0.06 * this.targets.length);
    const found = this.obstacles.filter((obstacle) => this.targets.reduce((sum, body) => sum + (this.hides(obstacle, eye, this.targetOf(body, motion, eye)) ? 1 : 0), 0) >= least);
    return new Set(found.map(({ body, index }) => shapeName(body, index)));
  }

  /** The part of the moving bodies, at some moments of the run, that something hides from this eye; all from under a plane. */
  blocked(eye: Vec): number {
    if (this.planes.some((plane) => this.isBehind(plane, eye))) return 1;
    const bodies = this.targets.filter((_, i) => i % Math.max(1, Math.ceil(this.targets.length / 10)) === 0);
    let blocked = 0;
    for (const motion of this.samples) {
      for (const body of bodies) {
        const target = this.targetOf(body, motion, eye);
        if (this.obstacles.some((obstacle) => this.hides(obstacle, eye, target))) ++blocked;
      }
    }
    return blocked / Math.max(1, bodies.length * this.samples.length);
  }

  get isOpen(): boolean {
    return this.obstacles.length === 0;
  }

  /** The point of a body that is nearest to the eye: what it lies on does not hide it. */
  private targetOf(body: number, motion: Motion, eye: Vec): Vec {
    const center = vectorAt(motion.position, body);
    const way = eye.map((x, c) => x - center[c]);
    const length = Math.hypot(...way) || 1;
    const radius = 0.7 * (this.source.header.bodies[body].radius ?? 0);
    return center.map((x, c) => x + (way[c] * Math.min(radius, 0.5 * length)) / length) as Vec;
  }

  private hides({ body, shape }: Obstacle, eye: Vec, target: Vec): boolean {
    const way = target.map((x, c) => x - eye[c]);
    const length = Math.hypot(...way);
    const center = vectorAt(this.start.position, body);
    const [w, x, y, z] = orientationAt(this.start, body);
    const inBody = (v: number[]) => turned([w, -x, -y, -z], v as Vec);
    const line = { from: inBody(eye.map((e, c) => e - center[c])), direction: inBody(way.map((v) => v / length)) };
    const distance = distanceToShapes(line, [shape], this.source.meshes);
    return distance !== undefined && distance < 0.999 * length;
  }

  private isBehind({ body, shape }: Obstacle, eye: Vec): boolean {
    const q = orientationAt(this.start, body);
    const normal = turned(q, turned(shape.q, shape.normal ?? [0, 0, 1]));
    const place = turned(q, shape.p).map((p, c) => p + this.start.position[3 * body + c] + normal[c] * (shape.offset ?? 0));
    return normal.reduce((sum, n, c) => sum + n * (eye[c] - place[c]), 0) < 0;
  }
}
