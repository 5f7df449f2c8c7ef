const sceneHelp: [string, string][] = [
  ["F", "follow the chosen body with the camera"],
  ["R", "look at the whole scene again"],
  ["Esc", "choose no body, close this help"],
  ["/", "find a body by name"],
  ["C", "contact points and forces"],
  ["V", "velocities"],
  ["X", "body frames"],
  ["I", "axes of inertia"],
  ["J", "joints and their axes (where there are joints)"],
  ["T", "trails"],
  ["P", "overlapping bodies"],
  ["H", "shadows"],
  ["M", "forces as a heat map: how hard each body is pressed"],
  ["S", "save a picture"],
  ["D", "dark or light"],
  ["?", "this help"],
];

/** What the keyboard does on the page of a stored run, in the order of the help. */
export const keyHelp: [string, string][] = [
  ["Space", "play, pause"],
  ["← →", "one frame back, on (with Shift: ten)"],
  ["Home End", "first, last frame"],
  ["[ ]", "previous, next impact"],
  ["− +", "slower, faster"],
  ["L", "loop"],
  ...sceneHelp,
  ["Shift P", "go to the deepest penetration"],
  ["G", "ghost of run B (where there is one)"],
];

/** The same on a live page. */
export const liveKeyHelp: [string, string][] = [
  ["Space", "run, pause"],
  ["← →", "one output interval back, on"],
  ["Home", "back to t = 0"],
  ["[ ]", "show the previous, next impact"],
  ...sceneHelp,
];
