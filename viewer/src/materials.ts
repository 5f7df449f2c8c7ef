import { bodyColors, rgb, type Rgb } from "./colors";
import type { Header, ShapeHeader } from "./header";

/** How the shaders draw a surface. */
export const looks = { plain: 0, metal: 1, wood: 2, rubber: 3, stone: 4, glossy: 5 } as const;

interface Look {
  words: RegExp;
  kind: number;
  color: string;
}

/** What the names of materials say of their looks; the first that fits counts. */
const known: Look[] = [
  { words: /brass|gold|bronze/i, kind: looks.metal, color: "#c7a04a" },
  { words: /copper/i, kind: looks.metal, color: "#bf7a4e" },
  { words: /steel|iron|metal|alumin|chrome|titan|lead|tungsten/i, kind: looks.metal, color: "#a9b3bd" },
  { words: /wood|oak|pine|beech|maple|birch|walnut|timber|plywood|table/i, kind: looks.wood, color: "#c18d57" },
  { words: /rubber|tyre|tire|felt|leather/i, kind: looks.rubber, color: "#5d636c" },
  { words: /stone|rock|granite|marble|concrete|brick|slate|ground|earth|clay|sand/i, kind: looks.stone, color: "#a8a196" },
  { words: /ice|glass|crystal/i, kind: looks.glossy, color: "#a6cfe2" },
  { words: /plastic|ivory|celluloid|bone|ceramic|porcelain|billiard/i, kind: looks.glossy, color: "#d9d3c4" },
];

/** More moving bodies than these are drawn in shades of a few colours. */
const mostColors = 12;
const fewColors = ["#5f8fb8", "#d19a5b", "#6fa78a", "#b185ad"];
const quiet: Record<string, Rgb> = { static: rgb("#9aa3ad"), kinematic: rgb("#7d8fa3") };

/** What a shape is drawn like. */
export interface Surface {
  kind: number;
  color: Rgb;
}

/** The looks of all shapes: by the colours that the scene gives, else by the names of the materials, else by the bodies. */
export class Surfaces {
  private readonly isCrowd: boolean;
  private readonly placeOf = new Map<number, number>();

  constructor(private readonly header: Header) {
    header.bodies.forEach(({ motion }, i) => motion === "dynamic" && this.placeOf.set(i, this.placeOf.size));
    this.isCrowd = this.placeOf.size > mostColors;
  }

  of(body: number, shape: ShapeHeader): Surface {
    const look = known.find(({ words }) => words.test(this.header.materials[shape.material]?.name ?? ""));
    const kind = look?.kind ?? looks.plain;
    if (shape.color) return { kind, color: rgb(shape.color) };
    const { motion, look: form } = this.header.bodies[body];
    if (motion !== "dynamic") return { kind, color: look ? mixed(rgb(look.color), quiet[motion], 0.55) : quiet[motion] };
    if (look) return { kind, color: shaded(rgb(look.color), shade(body) * [1, 0.86, 1.1][form % 3]) };
    if (this.isCrowd) return { kind, color: shaded(rgb(fewColors[form % fewColors.length]), shade(body)) };
    return { kind, color: rgb(bodyColors[(this.placeOf.get(body) ?? 0) % bodyColors.length]) };
  }
}

/** A brightness between 0.86 and 1.1 that neighbours by number do not share. */
function shade(body: number): number {
  return 0.86 + 0.24 * ((body * 0.61803398875) % 1);
}

function shaded(color: Rgb, factor: number): Rgb {
  return color.map((c) => Math.min(1, c * factor)) as Rgb;
}

function mixed(a: Rgb, b: Rgb, part: number): Rgb {
  return a.map((x, c) => x + part * (b[c] - x)) as Rgb;
}
