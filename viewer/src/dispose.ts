import { Texture, type Mesh, type Object3D, type ShaderMaterial } from "three";

/** Gives back what the graphics card keeps for these objects; they are not drawn any more. */
export function dispose(root: Object3D): void {
  root.traverse((object) => {
    // Groups have neither.
    const { geometry, material } = object as Partial<Mesh>;
    geometry?.dispose();
    for (const own of [material ?? []].flat()) {
      for (const { value } of Object.values((own as ShaderMaterial).uniforms ?? {})) {
        if (value instanceof Texture) value.dispose();
      }
      own.dispose();
    }
  });
}
