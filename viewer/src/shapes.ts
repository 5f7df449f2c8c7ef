import {
  BackSide, BufferAttribute, BufferGeometry, CustomBlending, DataTexture, DoubleSide, FloatType, FrontSide, GLSL3, Group, InstancedBufferAttribute,
  InstancedBufferGeometry, Mesh, OneFactor, RGBAFormat, ShaderMaterial, Vector3, Vector4, ZeroFactor, type IUniform,
} from "three";
import { overlayColors, rgb } from "./colors";
import type { Motion } from "./frames";
import { drawnShape, makeGeometry } from "./geometry";
import { shapesOf, type Header, type ShapeHeader, type Vec } from "./header";
import { Surfaces } from "./materials";
import type { Mesh as StoredMesh } from "./run";
import {
  ballFragment, ballShadowFragment, ballShadowVertex, ballVertex, boxShadowVertex, boxVertex, shadowFragment, solidFragment, solidShadowVertex, solidVertex,
  tableWidth,
} from "./shaders";
import { shapeName } from "./sight";

export interface Item {
  body: number;
  /** Of the body. */
  index: number;
  shape: ShapeHeader;
}

/** How bodies are marked. */
export interface ShapeMarks {
  selected: number;
  overlapping: ReadonlySet<number>;
  /** Shapes that are drawn as glass, by shapeName. */
  glass: ReadonlySet<string>;
  /** Of each body 0 to 1, less than 0: none. */
  heat?: Float32Array;
}

/** All shapes that share a geometry: one draw call. */
interface Batch {
  items: Item[];
  /** Two texels a shape: position and mark, orientation. */
  pose: DataTexture;
}

/** Copies of a geometry up to this many vertices are written out; beyond they are instanced. */
const mostVertices = 2_000_000;

export interface ShapesOptions {
  /** Drawn see-through. */
  isGhost: boolean;
  /** Of a ghost. */
  tint?: string;
  /** From this run's origin to the one the scene is drawn about [m]. */
  offset: Vec;
}

/** The bodies of a run as instanced meshes and impostors of balls. */
export class Shapes {
  readonly group = new Group();
  /** The same shapes as the light sees them. */
  readonly shadows = new Group();
  readonly uniforms: Record<string, IUniform>;
  private readonly batches: Batch[] = [];

  /** light: the uniforms of the Sun. */
  constructor(private readonly header: Header, meshes: StoredMesh[], light: Record<string, IUniform>, private readonly options: ShapesOptions) {
    const ghost = rgb(options.tint ?? overlayColors.ghost);
    this.uniforms = {
      ...light,
      uPick: { value: 0 },
      uGhost: { value: options.isGhost ? 1 : 0 },
      uTint: { value: new Vector4(...ghost, options.isGhost ? 0.85 : 0) },
      uSelected: { value: new Vector3(...rgb(overlayColors.selected)) },
      uWarning: { value: new Vector3(...rgb(overlayColors.penetration)) },
    };
    const byKey = new Map<string, Item[]>();
    header.bodies.forEach((_, i) => {
      shapesOf(header, i).forEach((shape, index) => {
        const { key } = drawnShape(shape);
        if (key === "plane") return;
        const items = byKey.get(key) ?? [];
        byKey.set(key, items);
        items.push({ body: i, index, shape });
      });
    });
    const surfaces = new Surfaces(header);
    for (const [key, items] of byKey) this.addBatch(key, items, surfaces, meshes);
  }

  update(motion: Motion): void {
    for (const batch of this.batches) {
      const table = batch.pose.image.data as unknown as Float32Array;
      batch.items.forEach((item, i) => place(motion, item, this.options.offset, 8 * i, table));
      batch.pose.needsUpdate = true;
    }
  }

  mark({ selected, overlapping, glass, heat }: ShapeMarks): void {
    for (const batch of this.batches) {
      const table = batch.pose.image.data as unknown as Float32Array;
      batch.items.forEach(({ body, index }, i) => {
        const warmth = heat ? heat[body] : -1;
        table[8 * i + 3] = body === selected ? 1 : overlapping.has(body) ? 2 : glass.size > 0 && glass.has(shapeName(body, index)) ? 3 : warmth >= 0 ? 4 + warmth : 0;
      });
      batch.pose.needsUpdate = true;
    }
  }

  /** While picking, bodies are drawn in the colours of their numbers. */
  setPicking(what: "none" | "all" | "moving"): void {
    this.uniforms.uPick.value = { none: 0, all: 1, moving: 2 }[what];
  }

  private addBatch(key: string, items: Item[], surfaces: Surfaces, meshes: StoredMesh[]): void {
    const isBall = key === "sphere", isBox = key === "box";
    const pose = makeTable(items.length);
    const tables = { uPose: { value: pose }, uLook: { value: this.lookTable(items, surfaces) } };
    const single = makeGeometry(key, meshes);
    const size = /^mesh/.test(key) ? sizeOf(single) : 1;
    const geometry = copiesOf(single, items.length);
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: isBall ? ballVertex : isBox ? boxVertex : solidVertex,
      fragmentShader: isBall ? ballFragment : solidFragment,
      uniforms: { ...this.uniforms, ...tables, uIsRound: { value: isRound(key) ? 1 : 0 }, uIsFlat: { value: isBox ? 1 : 0 }, uSize: { value: size } },
      side: isBox ? DoubleSide : FrontSide,
      transparent: this.options.isGhost,
      // Where both runs are the same, the solid one is seen.
      polygonOffset: this.options.isGhost,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
      // Rims of balls and glass cover a part of the samples of a pixel.
      alphaToCoverage: !this.options.isGhost,
      // What covers a part leaves the picture opaque.
      ...(this.options.isGhost ? {} : { blending: CustomBlending, blendSrc: OneFactor, blendDst: ZeroFactor, blendSrcAlpha: ZeroFactor, blendDstAlpha: OneFactor }),
    });
    this.group.add(meshOf(geometry, material));
    if (!this.options.isGhost) this.shadows.add(meshOf(geometry, this.shadowMaterial(isBall, isBox, tables)));
    this.batches.push({ items, pose });
  }

  private lookTable(items: Item[], surfaces: Surfaces): DataTexture {
    const table = makeTable(items.length);
    const data = table.image.data as unknown as Float32Array;
    items.forEach(({ body, shape }, i) => {
      data.set(drawnShape(shape).scale, 8 * i);
      data[8 * i + 3] = this.header.bodies[body].motion === "static" ? -1 - body : body;
      const { color, kind } = surfaces.of(body, shape);
      data.set([...color, kind], 8 * i + 4);
    });
    return table;
  }

  private shadowMaterial(isBall: boolean, isBox: boolean, tables: Record<string, IUniform>): ShaderMaterial {
    return new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: isBall ? ballShadowVertex : isBox ? boxShadowVertex : solidShadowVertex,
      fragmentShader: isBall ? ballShadowFragment : shadowFragment,
      uniforms: { uLight: this.uniforms.uLight, ...tables },
      side: isBall || isBox ? DoubleSide : BackSide,
      colorWrite: false,
    });
  }
}

/** The farthest of a geometry's points from its origin. */
function sizeOf(geometry: BufferGeometry): number {
  geometry.computeBoundingSphere();
  return (geometry.boundingSphere?.radius ?? 0) || 1;
}

/** A table of two texels a shape. */
function makeTable(count: number): DataTexture {
  const rows = Math.max(1, Math.ceil((2 * count) / tableWidth));
  const table = new DataTexture(new Float32Array(4 * tableWidth * rows), tableWidth, rows, RGBAFormat, FloatType);
  table.needsUpdate = true;
  return table;
}

function copiesOf(geometry: BufferGeometry, count: number): BufferGeometry {
  return geometry.getAttribute("position").count * count <= mostVertices ? repeated(geometry, count) : instanced(geometry, count);
}

function meshOf(geometry: BufferGeometry, material: ShaderMaterial): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** All copies written out. Drawing in software takes each instance as a draw call of its own, this as one. */
function repeated(geometry: BufferGeometry, count: number): BufferGeometry {
  const result = new BufferGeometry();
  const vertices = geometry.getAttribute("position").count;
  for (const name of ["position", "normal"]) {
    const attribute = geometry.getAttribute(name);
    if (!attribute) continue;
    const array = new Float32Array(3 * vertices * count);
    for (let i = 0; i < count; ++i) array.set(attribute.array, 3 * vertices * i);
    result.setAttribute(name, new BufferAttribute(array, 3));
  }
  const index = geometry.index?.array ?? Uint32Array.from({ length: vertices }, (_, i) => i);
  result.setIndex(new BufferAttribute(Uint32Array.from({ length: index.length * count }, (_, k) => index[k % index.length] + vertices * Math.floor(k / index.length)), 1));
  result.setAttribute("shapeIndex", new BufferAttribute(Float32Array.from({ length: vertices * count }, (_, v) => Math.floor(v / vertices)), 1));
  return result;
}

function instanced(geometry: BufferGeometry, count: number): BufferGeometry {
  const result = new InstancedBufferGeometry();
  result.index = geometry.index;
  for (const name of ["position", "normal"]) {
    const attribute = geometry.getAttribute(name);
    if (attribute) result.setAttribute(name, attribute);
  }
  result.setAttribute("shapeIndex", new InstancedBufferAttribute(Float32Array.from({ length: count }, (_, i) => i), 1));
  result.instanceCount = count;
  return result;
}

function isRound(key: string): boolean {
  return /^(cylinder|cone|capsule|ellipsoid)/.test(key);
}

/** Pose of a shape from that of its body, p + R(q) p_BS and q q_BS, into a table: 3 numbers, one left alone, 4 numbers. */
function place(motion: Motion, { body, shape }: Item, offset: Vec, at: number, table: Float32Array): void {
  const q = motion.orientation;
  const x = q[4 * body], y = q[4 * body + 1], z = q[4 * body + 2], w = q[4 * body + 3];
  const [px, py, pz] = shape.p;
  const tx = 2 * (y * pz - z * py), ty = 2 * (z * px - x * pz), tz = 2 * (x * py - y * px);
  table[at] = motion.position[3 * body] + offset[0] + px + w * tx + y * tz - z * ty;
  table[at + 1] = motion.position[3 * body + 1] + offset[1] + py + w * ty + z * tx - x * tz;
  table[at + 2] = motion.position[3 * body + 2] + offset[2] + pz + w * tz + x * ty - y * tx;
  const [sw, sx, sy, sz] = shape.q;
  table[at + 4] = w * sx + x * sw + y * sz - z * sy;
  table[at + 5] = w * sy - x * sz + y * sw + z * sx;
  table[at + 6] = w * sz + x * sy - y * sx + z * sw;
  table[at + 7] = w * sw - x * sx - y * sy - z * sz;
}
