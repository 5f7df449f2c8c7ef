import { DepthTexture, LessEqualCompare, LinearFilter, Matrix4, OrthographicCamera, Scene, UnsignedIntType, Vector3, WebGLRenderTarget, type IUniform, type WebGLRenderer } from "three";
import type { Extent } from "./extent";

export type ShadowQuality = "none" | "coarse" | "hard" | "soft";
const sizes = { none: 1, coarse: 512, hard: 1024, soft: 2048 };

/** The light from the sky, and the map of depths that it sees: what lies behind them is in the shadow. */
export class Sun {
  /** What throws shadows. */
  readonly scene = new Scene();
  readonly uniforms: Record<string, IUniform>;
  private readonly camera = new OrthographicCamera();
  private readonly light = new Vector3();
  private readonly matrix = new Matrix4();
  private target: WebGLRenderTarget;
  private quality: ShadowQuality = "soft";
  private reach = 1;

  constructor(up: Vector3) {
    // Over the viewer's left shoulder, as seen from the front.
    const side = Math.abs(up.z) > 0.7 ? new Vector3(-0.45, -0.35, 0) : new Vector3(-0.4, 0.3, 0.35);
    this.light.copy(up).add(side.projectOnPlane(up)).normalize();
    this.target = makeTarget(sizes.soft);
    this.uniforms = {
      uUp: { value: up }, uLight: { value: this.light }, uShadowMatrix: { value: this.matrix }, uShadowMap: { value: this.target.depthTexture },
      uShadows: { value: 2 }, uTexel: { value: 0 },
    };
  }

  setQuality(quality: ShadowQuality): void {
    if (quality === this.quality) return;
    this.quality = quality;
    this.uniforms.uShadows.value = { none: 0, coarse: 1, hard: 1, soft: 2 }[quality];
    this.target.dispose();
    this.target = makeTarget(sizes[quality]);
    this.uniforms.uShadowMap.value = this.target.depthTexture;
    this.aim();
  }

  /** Lights what lies within a box and some way around it. */
  fit(extent: Extent): void {
    const center = new Vector3(...extent.center);
    this.reach = 1.25 * extent.radius;
    this.camera.position.copy(center).addScaledVector(this.light, 5 * this.reach);
    this.camera.up.set(0, 0, 1).addScaledVector(this.light, -this.light.z);
    if (this.camera.up.length() < 0.1) this.camera.up.set(0, 1, 0);
    this.camera.lookAt(center);
    this.aim();
  }

  draw(renderer: WebGLRenderer): void {
    if (this.quality === "none") return;
    const before = renderer.getRenderTarget();
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0xffffff, 1);
    renderer.clear();
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(before);
  }

  private aim(): void {
    const { camera, reach } = this;
    [camera.left, camera.right, camera.bottom, camera.top, camera.near, camera.far] = [-reach, reach, -reach, reach, 0.5 * reach, 12 * reach];
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    // From -1..1 to 0..1, where maps are read.
    this.matrix.set(0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 1).multiply(camera.projectionMatrix).multiply(camera.matrixWorldInverse);
    this.uniforms.uTexel.value = (2 * reach) / sizes[this.quality];
  }
}

function makeTarget(size: number): WebGLRenderTarget {
  const depthTexture = new DepthTexture(size, size, UnsignedIntType);
  depthTexture.compareFunction = LessEqualCompare;
  depthTexture.minFilter = depthTexture.magFilter = LinearFilter;
  return new WebGLRenderTarget(size, size, { depthTexture });
}
