import { Color, GLSL3, Group, Mesh, PlaneGeometry, Quaternion, ShaderMaterial, Vector3, type IUniform } from "three";
import type { Motion } from "./frames";
import type { Header, ShapeHeader, Vec } from "./header";
import { groundFragment, groundVertex } from "./shaders";

interface Plane {
  body: number;
  shape: ShapeHeader;
  mesh: Mesh<PlaneGeometry, ShaderMaterial>;
}

/** The scene's half-spaces: each a fading sheet with a grid that belongs to its body. */
export class Ground {
  readonly group = new Group();
  private readonly planes: Plane[] = [];

  constructor(header: Header, private readonly center: Vector3, reach: number, light: Record<string, IUniform>, private readonly offset: Vec) {
    const cell = 10 ** Math.floor(Math.log10(reach / 6));
    header.bodies.forEach((body, i) => {
      for (const shape of header.looks[body.look]) {
        if (shape.type !== "plane") continue;
        const material = new ShaderMaterial({
          glslVersion: GLSL3, vertexShader: groundVertex, fragmentShader: groundFragment, transparent: true,
          depthWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
          uniforms: {
            ...light,
            uColor: { value: new Color() }, uLine: { value: new Color() }, uCell: { value: cell }, uReach: { value: 4 * reach },
            uShift: { value: [0, 0] },
          },
        });
        const mesh = new Mesh(new PlaneGeometry(8 * reach, 8 * reach), material);
        mesh.renderOrder = -1;
        this.planes.push({ body: i, shape, mesh });
        this.group.add(mesh);
      }
    });
  }

  setColors(color: string, line: string): void {
    for (const { mesh } of this.planes) {
      mesh.material.uniforms.uColor.value.setStyle(color, "");
      mesh.material.uniforms.uLine.value.setStyle(line, "");
    }
  }

  /** Lays each sheet into its plane, its middle under the scene's. */
  update(motion: Motion): void {
    for (const { body, shape, mesh } of this.planes) {
      const q = new Quaternion().fromArray(motion.orientation, 4 * body);
      const p = new Vector3().fromArray(motion.position, 3 * body).add(new Vector3(...this.offset));
      const [w, x, y, z] = shape.q;
      p.add(new Vector3(...shape.p).applyQuaternion(q));
      q.multiply(new Quaternion(x, y, z, w));
      const normal = new Vector3(...(shape.normal ?? [0, 0, 1]));
      const lay = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal);
      const onPlane = p.clone().add(normal.clone().multiplyScalar(shape.offset ?? 0).applyQuaternion(q));
      q.multiply(lay);
      const away = this.center.clone().sub(onPlane).applyQuaternion(q.clone().invert());
      mesh.quaternion.copy(q);
      mesh.position.copy(new Vector3(away.x, away.y, 0).applyQuaternion(q).add(onPlane));
      mesh.material.uniforms.uShift.value = [away.x, away.y];
    }
  }
}
