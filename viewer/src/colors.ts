export type Rgb = [number, number, number];

/**
 * Eight colours that the colour-blind tell apart. Source: Okabe and Ito, Color Universal Design, 2008 (their black is
 * left out, a grey stands for it).
 */
export const palette = {
  orange: "#e69f00",
  skyBlue: "#56b4e9",
  green: "#009e73",
  yellow: "#f0e442",
  blue: "#0072b2",
  vermilion: "#d55e00",
  purple: "#cc79a7",
  grey: "#8c8c8c",
} as const;

export const bodyColors = [
  palette.skyBlue, palette.orange, palette.green, palette.purple, palette.yellow, palette.blue, palette.vermilion,
];

/** Colours of what is drawn over the bodies; each also differs in shape, so that none is told by colour alone. */
export const overlayColors = {
  stick: palette.green,
  slide: palette.vermilion,
  open: palette.grey,
  unknown: palette.grey,
  normal: palette.skyBlue,
  velocity: palette.yellow,
  impulse: palette.purple,
  penetration: palette.vermilion,
  x: palette.vermilion,
  y: palette.green,
  z: palette.blue,
  selected: palette.orange,
  ghost: palette.skyBlue,
} as const;

/** Colours of runs that are compared, in their order. */
export const runColors = [
  palette.skyBlue, palette.orange, palette.green, palette.purple, palette.vermilion, palette.blue, palette.yellow, palette.grey,
];

/** Components in 0..1 of "#rgb" or "#rrggbb"; grey for anything else. */
export function rgb(text: string): Rgb {
  const short = /^#([0-9a-f])([0-9a-f])([0-9a-f])$/i.exec(text);
  const digits = short ? short.slice(1).map((d) => d + d) : /^#(..)(..)(..)$/.exec(text)?.slice(1);
  const values = digits?.map((d) => parseInt(d, 16) / 255) ?? [];
  return values.length === 3 && values.every(Number.isFinite) ? (values as Rgb) : [0.55, 0.55, 0.55];
}
