import {
  BoxGeometry, BufferAttribute, BufferGeometry, DataTexture, DoubleSide, EqualStencilFunc, FloatType, FrontSide, GLSL3, Group, IcosahedronGeometry,
  IncrementStencilOp, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, RGBAFormat, ShaderMaterial, Vector3, Vector4,
  type IUniform,
} from "three";
import { defaultColor, overlayColors, rgb } from "./colors";
import type { Motion } from "./frames";
import { drawnShape, makeGeometry } from "./geometry";
import { shapesOf, type Header, type ShapeHeader, type Vec } from "./header";
import type { Mesh as StoredMesh } from "./run";
import { ballFragment, ballVertex, boxVertex, shadowFragment, shadowVertex, solidFragment, solidVertex, tableWidth } from "./shaders";

export interface Item {
  body: number;
  shape: ShapeHeader;
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
  readonly uniforms: Record<string, IUniform>;
  private readonly batches: Batch[] = [];
  private readonly shadows = new Group();
  private readonly plane = { value: new Vector4(0, 0, 1, 0) };
  private readonly light = { value: new Vector3(0.2, 0.1, 1).normalize() };

  constructor(private readonly header: Header, meshes: StoredMesh[], up: Vector3, private readonly options: ShapesOptions) {
    const ghost = rgb(options.tint ?? overlayColors.ghost);
    this.uniforms = {
      uUp: { value: up },
      uPick: { value: 0 },
      uAlpha: { value: options.isGhost ? 0.4 : 1 },
      uTint: { value: new Vector4(...ghost, options.isGhost ? 0.75 : 0) },
      uSelected: { value: new Vector3(...rgb(overlayColors.selected)) },
      uWarning: { value: new Vector3(...rgb(overlayColors.penetration)) },
    };
    const byKey = new Map<string, Item[]>();
    header.bodies.forEach((_, i) => {
      for (const shape of shapesOf(header, i)) {
        const { key } = drawnShape(shape);
        if (key === "plane") continue;
        const items = byKey.get(key) ?? [];
        byKey.set(key, items);
        items.push({ body: i, shape });
      }
    });
    for (const [key, items] of byKey) this.addBatch(key, items, meshes);
    this.group.add(this.shadows);
    this.shadows.visible = false;
  }

  /** Throws shadows on the plane n · x = d (from the drawing's origin). */
  castOn(normal: Vector3, distance: number): void {
    this.plane.value.set(normal.x, normal.y, normal.z, distance);
    const side = new Vector3(0.3, 0.2, 0).projectOnPlane(normal);
    this.light.value.copy(normal).add(side).normalize();
    this.shadows.visible = !this.options.isGhost;
  }

  set hasShadows(shown: boolean) {
    this.shadows.visible = shown;
  }

  update(motion: Motion): void {
    for (const batch of this.batches) {
      const table = batch.pose.image.data as unknown as Float32Array;
      batch.items.forEach((item, i) => place(motion, item, this.options.offset, 8 * i, table));
      batch.pose.needsUpdate = true;
    }
  }

  /** Marks the selected body and those that overlap. */
  mark(selected: number, overlapping: ReadonlySet<number>): void {
    for (const batch of this.batches) {
      const table = batch.pose.image.data as unknown as Float32Array;
      batch.items.forEach(({ body }, i) => (table[8 * i + 3] = body === selected ? 1 : overlapping.has(body) ? 2 : 0));
      batch.pose.needsUpdate = true;
    }
  }

  /** While picking, bodies are drawn in the colours of their numbers and shadows are not. */
  setPicking(isPicking: boolean): void {
    this.uniforms.uPick.value = isPicking ? 1 : 0;
    this.shadows.traverse((object) => object.layers.set(isPicking ? 1 : 0));
  }

  private addBatch(key: string, items: Item[], meshes: StoredMesh[]): void {
    const isBall = key === "sphere", isBox = key === "box";
    const pose = makeTable(items.length);
    const tables = { uPose: { value: pose }, uLook: { value: this.lookTable(items) } };
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: isBall ? ballVertex : isBox ? boxVertex : solidVertex,
      fragmentShader: isBall ? ballFragment : solidFragment,
      uniforms: { ...this.uniforms, ...tables, uIsRound: { value: isRound(key) ? 1 : 0 }, uIsFlat: { value: isBox ? 1 : 0 } },
      side: isBox ? DoubleSide : FrontSide,
      transparent: this.options.isGhost,
    });
    this.group.add(meshOf(makeGeometry(key, meshes), items.length, material));
    const standIn = isBall ? new IcosahedronGeometry(1, 2) : isBox ? new BoxGeometry(2, 2, 2) : makeGeometry(key, meshes);
    const shadow = meshOf(standIn, items.length, this.shadowMaterial(tables));
    shadow.renderOrder = 1;
    this.shadows.add(shadow);
    this.batches.push({ items, pose });
  }

  private lookTable(items: Item[]): DataTexture {
    const table = makeTable(items.length);
    const data = table.image.data as unknown as Float32Array;
    items.forEach(({ body, shape }, i) => {
      data.set(drawnShape(shape).scale, 8 * i);
      data[8 * i + 3] = body;
      data.set(rgb(shape.color || defaultColor(this.header.bodies[body].motion, body)), 8 * i + 4);
    });
    return table;
  }

  /** Each point of the ground is darkened once, however many bodies are above it. */
  private shadowMaterial(tables: Record<string, IUniform>): ShaderMaterial {
    return new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: shadowVertex,
      fragmentShader: shadowFragment,
      uniforms: { uPlane: this.plane, uLight: this.light, ...tables },
      transparent: true,
      side: DoubleSide,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
      stencilWrite: true,
      stencilRef: 0,
      stencilFunc: EqualStencilFunc,
      stencilZPass: IncrementStencilOp,
    });
  }
}

/** A table of two texels a shape. */
function makeTable(count: number): DataTexture {
  const rows = Math.max(1, Math.ceil((2 * count) / tableWidth));
  const table = new DataTexture(new Float32Array(4 * tableWidth * rows), tableWidth, rows, RGBAFormat, FloatType);
  table.needsUpdate = true;
  return table;
}

function meshOf(geometry: BufferGeometry, count: number, material: ShaderMaterial): Mesh {
  const vertices = geometry.getAttribute("position").count;
  const mesh = new Mesh(vertices * count <= mostVertices ? repeated(geometry, count) : instanced(geometry, count), material);
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
