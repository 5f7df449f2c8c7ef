import { BufferAttribute, BufferGeometry, CapsuleGeometry, ConeGeometry, CylinderGeometry, PlaneGeometry, SphereGeometry } from "three";
import type { ShapeHeader, Vec } from "./header";
import type { Mesh } from "./run";

/** What a shape is drawn from: a geometry that many may share, and its own stretch along the axes. */
export interface DrawnShape {
  /** Shapes with the same key share the geometry. "sphere" is drawn as an impostor. */
  key: string;
  scale: Vec;
}

export function drawnShape(shape: ShapeHeader): DrawnShape {
  const r = shape.radius ?? 1;
  const half = shape.half_length ?? 1;
  switch (shape.type) {
    case "sphere":
      return { key: "sphere", scale: [r, r, r] };
    case "box":
      return { key: "box", scale: shape.half_extents ?? [1, 1, 1] };
    case "ellipsoid":
      return { key: "ellipsoid", scale: shape.radii ?? [1, 1, 1] };
    case "cylinder":
    case "cone":
      return { key: shape.type, scale: [r, r, half] };
    case "capsule":
      // Its round ends do not stretch: one geometry for each proportion.
      return { key: `capsule ${half / r}`, scale: [r, r, r] };
    case "plane":
      return { key: "plane", scale: [1, 1, 1] };
    case "convex":
    case "mesh":
      return { key: `mesh ${shape.mesh}`, scale: [1, 1, 1] };
  }
}

/** The geometry of a key; round axes are z, as in rigor/geometry/shape/shape.hpp. Impostors get a square. */
export function makeGeometry(key: string, meshes: Mesh[]): BufferGeometry {
  const [type, parameter] = key.split(" ");
  switch (type) {
    case "sphere":
      return new PlaneGeometry(2, 2);
    case "box":
      return boxCorner();
    case "ellipsoid":
      return new SphereGeometry(1, 32, 20).rotateX(Math.PI / 2);
    case "cylinder":
      return new CylinderGeometry(1, 1, 2, 40).rotateX(Math.PI / 2);
    case "cone":
      return new ConeGeometry(1, 2, 40).rotateX(Math.PI / 2);
    case "capsule":
      return new CapsuleGeometry(1, 2 * Number(parameter), 8, 24).rotateX(Math.PI / 2);
    default:
      return flatGeometry(meshes[Number(parameter)]);
  }
}

/** The three faces of a cube at its corner (1, 1, 1). */
function boxCorner(): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = [[1, 1, 1], [-1, 1, 1], [-1, -1, 1], [1, -1, 1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]];
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1]);
  return geometry;
}

/** Triangles with their own normals, so that a polyhedron shows its faces. */
function flatGeometry(mesh: Mesh): BufferGeometry {
  const positions = new Float32Array(3 * mesh.triangles.length);
  mesh.triangles.forEach((vertex, i) => positions.set(mesh.vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}
