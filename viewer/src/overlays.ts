import {
  BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, DynamicDrawUsage, GLSL3, InstancedBufferAttribute,
  InstancedBufferGeometry, LineBasicMaterial, LineSegments, Mesh, Points, ShaderMaterial,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Rgb } from "./colors";
import { arrowFragment, arrowVertex, pointFragment, pointVertex } from "./shaders";

/** A list of numbers that grows, for attributes that are filled anew each time. */
class Buffer {
  array = new Float32Array(3 * 64);
  size = 0;

  push(x: number, y: number, z: number): void {
    if (this.size + 3 > this.array.length) {
      const larger = new Float32Array(2 * this.array.length);
      larger.set(this.array);
      this.array = larger;
    }
    this.array[this.size++] = x;
    this.array[this.size++] = y;
    this.array[this.size++] = z;
  }
}

/** Arrows over the bodies, seen through those that they lie in; what is in front of these hides them. */
export class Arrows {
  readonly mesh: Mesh;
  private readonly geometry = new InstancedBufferGeometry();
  private readonly start = new Buffer();
  private readonly vector = new Buffer();
  private readonly color = new Buffer();

  /** bias: so much in front of them is no obstacle [m]. */
  constructor(pixel: { value: number }, bias: number) {
    const shaft = new CylinderGeometry(1, 1, 1, 6, 1, true).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const head = new ConeGeometry(1, 1, 10).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const merged = mergeGeometries([shaft, head]);
    const shaftCount = shaft.getAttribute("position").count;
    const part = Float32Array.from({ length: merged.getAttribute("position").count }, (_, i) => (i < shaftCount ? 0 : 1));
    this.geometry.index = merged.index;
    this.geometry.setAttribute("position", merged.getAttribute("position"));
    this.geometry.setAttribute("part", new BufferAttribute(part, 1));
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: arrowVertex, fragmentShader: arrowFragment, uniforms: { uPixel: pixel, uBias: { value: bias } },
      depthWrite: false, transparent: true,
    });
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 10;
    this.mesh.layers.enable(0);
  }

  clear(): void {
    this.start.size = this.vector.size = this.color.size = 0;
  }

  add(start: ArrayLike<number>, vector: ArrayLike<number>, color: Rgb): void {
    this.start.push(start[0], start[1], start[2]);
    this.vector.push(vector[0], vector[1], vector[2]);
    this.color.push(...color);
  }

  /** Gives what was added to the drawing. */
  commit(): void {
    setAttribute(this.geometry, "iStart", this.start, true);
    setAttribute(this.geometry, "iVector", this.vector, true);
    setAttribute(this.geometry, "iColor", this.color, true);
    this.geometry.instanceCount = this.start.size / 3;
    this.mesh.visible = this.start.size > 0;
  }
}

/** How large discs are. */
export interface DotSize {
  /** In the scene [m], and on the screen at most [CSS pixels]. */
  size: number;
  most: number;
  /** So much in front of them is no obstacle [m]. */
  bias: number;
}

/** Discs that face the eye. */
export class Dots {
  readonly points: Points;
  private readonly geometry = new BufferGeometry();
  private readonly place = new Buffer();
  private readonly color = new Buffer();

  constructor({ size, most, bias }: DotSize, pixel: { value: number }, ratio: { value: number }) {
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: pointVertex, fragmentShader: pointFragment,
      uniforms: { uRatio: ratio, uPixel: pixel, uDot: { value: size }, uMost: { value: most }, uBias: { value: bias } }, depthWrite: false, transparent: true,
    });
    this.points = new Points(this.geometry, material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 11;
  }

  clear(): void {
    this.place.size = this.color.size = 0;
  }

  add(place: ArrayLike<number>, color: Rgb): void {
    this.place.push(place[0], place[1], place[2]);
    this.color.push(...color);
  }

  commit(): void {
    setAttribute(this.geometry, "position", this.place, false);
    setAttribute(this.geometry, "color", this.color, false);
    this.geometry.setDrawRange(0, this.place.size / 3);
    this.points.visible = this.place.size > 0;
  }
}

/** Lines: trails, springs, rods of joints. */
export class Lines {
  readonly lines: LineSegments;
  private readonly geometry = new BufferGeometry();
  private readonly place = new Buffer();
  private readonly color = new Buffer();

  constructor() {
    this.lines = new LineSegments(this.geometry, new LineBasicMaterial({ vertexColors: true, toneMapped: false }));
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 5;
  }

  clear(): void {
    this.place.size = this.color.size = 0;
  }

  add(from: ArrayLike<number>, to: ArrayLike<number>, color: Rgb): void {
    this.place.push(from[0], from[1], from[2]);
    this.place.push(to[0], to[1], to[2]);
    this.color.push(...color);
    this.color.push(...color);
  }

  commit(): void {
    setAttribute(this.geometry, "position", this.place, false);
    setAttribute(this.geometry, "color", this.color, false);
    this.geometry.setDrawRange(0, this.place.size / 3);
    this.lines.visible = this.place.size > 0;
  }
}

/** Puts the buffer's numbers where the card reads them; a larger array needs a new attribute. */
function setAttribute(geometry: BufferGeometry, name: string, buffer: Buffer, isInstanced: boolean): void {
  const present = geometry.getAttribute(name) as BufferAttribute | undefined;
  if (present?.array === buffer.array) {
    present.needsUpdate = true;
    return;
  }
  const attribute = isInstanced ? new InstancedBufferAttribute(buffer.array, 3) : new BufferAttribute(buffer.array, 3);
  attribute.setUsage(DynamicDrawUsage);
  geometry.setAttribute(name, attribute);
}
