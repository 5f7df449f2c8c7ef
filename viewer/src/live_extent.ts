import type { Extent } from "./extent";
import type { Header, Vec } from "./header";
import { add, turned } from "./marks";

/**
 * What is worth looking at while nobody knows where the bodies will go: where they are, and below them every static plane that
 * is nearer than sixty times their size.
 */
export function withPlanes(header: Header, extent: Extent): Extent {
  let lower = extent.center.map((x, c) => x - extent.half[c]) as Vec;
  let upper = extent.center.map((x, c) => x + extent.half[c]) as Vec;
  for (const body of header.bodies.filter(({ motion }) => motion === "static")) {
    for (const shape of header.looks[body.look]) {
      if (shape.type !== "plane") continue;
      const local = shape.normal ?? [0, 0, 1];
      const normal = turned(body.start.q, turned(shape.q, local));
      const place = add(add(body.start.p, turned(body.start.q, shape.p)), normal.map((n) => n * (shape.offset ?? 0)) as Vec);
      const above = normal.reduce((sum, n, c) => sum + n * (extent.center[c] + header.origin[c] - place[c]), 0);
      if (!(above > 0) || above > 60 * extent.radius) continue;
      const foot = extent.center.map((x, c) => x - above * normal[c]);
      lower = lower.map((x, c) => Math.min(x, foot[c])) as Vec;
      upper = upper.map((x, c) => Math.max(x, foot[c])) as Vec;
    }
  }
  return {
    center: lower.map((x, c) => (x + upper[c]) / 2) as Vec,
    half: lower.map((x, c) => (upper[c] - x) / 2) as Vec,
    radius: Math.hypot(...lower.map((x, c) => upper[c] - x)) / 2,
  };
}
