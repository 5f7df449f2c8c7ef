/** Turns a vector by a quaternion x y z w. */
const turn = `
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }`;

/** What of the light reaches a point: a map of depths seen from the light, read between its texels. 0: no shadows, 1: hard, 2: soft. */
const shadow = `
uniform mat4 uShadowMatrix; uniform highp sampler2DShadow uShadowMap; uniform float uShadows; uniform float uTexel;
float lightAt(vec3 world, vec3 normal) {
  if (uShadows < 0.5) return 1.0;
  vec3 at = (uShadowMatrix * vec4(world + 2.0 * uTexel * normal, 1.0)).xyz;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  if (uShadows < 1.5) return texture(uShadowMap, at);
  vec2 size = vec2(textureSize(uShadowMap, 0));
  float sum = 0.0;
  for (int i = 0; i < 16; ++i) {
    vec2 off = 2.6 * (vec2(i & 3, i >> 2) - 1.5);
    sum += texture(uShadowMap, vec3(at.xy + off / size, at.z));
  }
  return sum / 16.0;
}`;

/** A sun, the sky, what the ground throws back, and a little light from the eye. Metal mirrors sky and ground. */
const shade = `
uniform vec3 uUp; uniform vec3 uLight;
${shadow}
vec3 shade(vec3 color, vec3 normal, vec3 toEye, vec3 world, float kind) {
  float sky = 0.5 + 0.5 * dot(normal, uUp);
  float direct = max(dot(normal, uLight), 0.0);
  float light = direct > 0.0 ? lightAt(world, normal) : 0.0;
  float facing = max(dot(normal, toEye), 0.0);
  float gloss = pow(max(dot(normal, normalize(uLight + toEye)), 0.0), kind == 1.0 ? 90.0 : 36.0) * light;
  vec3 diffuse = color * (0.34 + 0.26 * sky + 0.10 * facing + 0.46 * direct * light);
  if (kind == 1.0) {
    vec3 mirrored = reflect(-toEye, normal);
    float horizon = smoothstep(-0.25, 0.35, dot(mirrored, uUp));
    diffuse = mix(diffuse, color * mix(0.55, 1.2, horizon) * (0.8 + 0.2 * light), 0.55);
  }
  float strength = kind == 1.0 ? 0.55 : kind == 3.0 ? 0.03 : kind == 2.0 ? 0.07 : kind == 4.0 ? 0.02 : kind == 5.0 ? 0.5 : 0.14;
  return diffuse + strength * gloss;
}`;

/** The grain of wood, the speckles of stone. Places are in units of the body's size; what is finer than a pixel fades. */
const surface = `
float hash(vec3 p) {
  p = fract(p * 0.3183099 + 0.1);
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float noise(vec3 x) {
  vec3 i = floor(x), f = fract(x);
  f = f * f * (3.0 - 2.0 * f);
  vec2 d = vec2(0.0, 1.0);
  return mix(mix(mix(hash(i), hash(i + d.yxx), f.x), mix(hash(i + d.xyx), hash(i + d.yyx), f.x), f.y),
             mix(mix(hash(i + d.xxy), hash(i + d.yxy), f.x), mix(hash(i + d.xyy), hash(i + d.yyy), f.x), f.y), f.z);
}
vec3 surface(vec3 color, float kind, vec3 place, float body) {
  float fine = length(fwidth(place));
  if (kind == 2.0) {
    vec3 p = place + vec3(0.37, 1.61, 0.0) + 0.13 * mod(body, 7.0);
    float ring = 5.0 * length(p.xy + 0.12 * vec2(noise(3.0 * p), noise(3.0 * p + 9.0)));
    float grain = 0.5 + 0.5 * sin(6.2831853 * ring);
    return color * (1.0 - 0.17 * grain * (1.0 - smoothstep(0.03, 0.12, fine)));
  }
  if (kind == 4.0) {
    float speckle = 0.6 * noise(7.0 * place + body) + 0.4 * noise(19.0 * place);
    return color * (1.0 + 0.28 * (speckle - 0.5) * (1.0 - smoothstep(0.05, 0.2, fine)));
  }
  return color;
}`;

/**
 * One more than the body's number as a colour (picking: 1 all but glass, 2 what moves), or what is seen. What stands still has -1 minus its
 * number. The mark says how: 1 the selected body, 2 an overlapping one, 3 glass,
 * 4 to 5 the colour of a force. `edge` is 1 on the edges of a box. A ghost is a shell: its rims and edges are seen best.
 */
const finish = `
uniform float uPick;
uniform float uGhost;
uniform vec4 uTint;
uniform vec3 uSelected;
uniform vec3 uWarning;
out vec4 fragment;
vec3 heat(float t) {
  vec3 cold = vec3(0.16, 0.20, 0.42), warm = vec3(0.80, 0.28, 0.36), hot = vec3(0.99, 0.88, 0.42);
  return t < 0.5 ? mix(cold, warm, 2.0 * t) : mix(warm, hot, 2.0 * t - 1.0);
}
vec4 finish(vec3 color, vec3 normal, vec3 toEye, vec3 world, float body, float mark, float kind, float edge) {
  if (uPick > 0.5) {
    if (mark > 2.5 && mark < 3.5 || uPick > 1.5 && body < 0.0) discard;
    float number = body < 0.0 ? -body : body + 1.0;
    return vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0;
  }
  if (mark > 3.5) { color = heat(mark - 4.0); kind = 0.0; }
  vec3 base = mix(color, uTint.rgb, uTint.a);
  vec3 lit = shade(base, normal, toEye, world, kind) * (1.0 - 0.22 * edge);
  float rim = 1.0 - max(dot(normal, toEye), 0.0);
  if (uGhost > 0.5) return vec4(mix(lit, uTint.rgb, 0.6), max(0.20, max(0.85 * edge, smoothstep(0.35, 0.85, rim))));
  if (mark > 2.5 && mark < 3.5) return vec4(mix(lit, vec3(1.0), 0.25), max(0.26, 0.8 * edge));
  if (mark > 1.5 && mark < 2.5) lit = mix(lit, uWarning, 0.55);
  else if (mark > 0.5 && mark < 1.5) lit = mix(lit, uSelected, 0.25 + 0.75 * max(edge, smoothstep(0.45, 0.75, rim)));
  return vec4(lit, 1.0);
}`;

/** Width of the tables of shapes; each shape has two texels in one row. */
export const tableWidth = 2048;

/** Where a shape is (position and mark, orientation) and what it is like (scale and body, colour). */
const instance = `
in float shapeIndex;
uniform highp sampler2D uPose; uniform highp sampler2D uLook;
flat out vec3 vColor; flat out vec3 vMark;
vec3 iPosition; vec4 iOrientation; vec3 iScale;
void readShape() {
  int at = 2 * int(shapeIndex + 0.5);
  ivec2 first = ivec2(at % ${tableWidth}, at / ${tableWidth}), second = first + ivec2(1, 0);
  vec4 place = texelFetch(uPose, first, 0), size = texelFetch(uLook, first, 0);
  iPosition = place.xyz; iOrientation = texelFetch(uPose, second, 0); iScale = size.xyz;
  vec4 color = texelFetch(uLook, second, 0);
  vColor = color.rgb; vMark = vec3(size.w, place.w, color.a);
}`;

export const solidVertex = `${instance}${turn}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn; out vec3 vPlace;
uniform float uSize;
void main() {
  readShape();
  vNormal = turn(iOrientation, normalize(normal / iScale));
  vOwn = position;
  vPlace = position * iScale / (uSize * max(iScale.x, max(iScale.y, iScale.z)));
  vWorld = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

/** Of a box only the three faces on the eye's side are drawn: those of the corner (1, 1, 1), mirrored to where the eye is. */
export const boxVertex = `${instance}${turn}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn; out vec3 vPlace;
void main() {
  readShape();
  vec3 eye = turn(vec4(-iOrientation.xyz, iOrientation.w), cameraPosition - iPosition);
  vOwn = position * vec3(eye.x < 0.0 ? -1.0 : 1.0, eye.y < 0.0 ? -1.0 : 1.0, eye.z < 0.0 ? -1.0 : 1.0);
  vPlace = vOwn * iScale / max(iScale.x, max(iScale.y, iScale.z));
  vNormal = vec3(0.0);
  vWorld = iPosition + turn(iOrientation, vOwn * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

/** Quarters of round shapes alternate, so that turning is seen; flat ones take their normals from the drawn surface. */
export const solidFragment = `
flat in vec3 vColor; flat in vec3 vMark; in vec3 vNormal; in vec3 vWorld; in vec3 vOwn; in vec3 vPlace;
${shade}${surface}${finish}
uniform float uIsRound; uniform float uIsFlat;
/** 1 within a pixel of the edge between two faces of a box. */
float edgeOfBox() {
  vec3 off = 1.0 - abs(vOwn);
  float nearest = max(min(off.x, off.y), min(max(off.x, off.y), off.z));
  float pixels = fwidth(nearest);
  return (1.0 - smoothstep(0.6, 1.5, nearest / max(pixels, 1e-6))) * (1.0 - smoothstep(0.08, 0.3, pixels));
}
void main() {
  vec3 toEye = normalize(cameraPosition - vWorld);
  vec3 normal = normalize(uIsFlat > 0.5 ? cross(dFdx(vWorld), dFdy(vWorld)) : vNormal);
  if (dot(normal, toEye) < 0.0 && uIsFlat > 0.5) normal = -normal;
  vec3 color = surface(vColor, vMark.z, vPlace, vMark.x) * (uIsRound > 0.5 && vOwn.x * vOwn.y > 0.0 ? 0.84 : 1.0);
  fragment = finish(color, normal, toEye, vWorld, vMark.x, vMark.y, vMark.z, uIsFlat > 0.5 ? edgeOfBox() : 0.0);
}`;

/** A square that just covers the ball as seen from the eye (view space, eye at the origin, perspective). */
export const ballVertex = `${instance}
out vec3 vRay; flat out vec3 vCenter; flat out vec4 vTurn; flat out float vRadius;
void main() {
  readShape();
  vTurn = iOrientation; vRadius = iScale.x;
  vCenter = (viewMatrix * vec4(iPosition, 1.0)).xyz;
  float d2 = dot(vCenter, vCenter);
  float reach = 1.03 * vRadius * sqrt(d2 / max(d2 - vRadius * vRadius, 1e-6 * d2));
  vec3 z = -vCenter / sqrt(d2);
  vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
  vRay = vCenter + reach * (position.x * x + position.y * cross(z, x));
  gl_Position = projectionMatrix * vec4(vRay, 1.0);
}`;

/** The ray meets the ball nearest to the eye; octants of the body frame alternate, so that turning is seen. Its rim covers a part of its pixels. */
export const ballFragment = `
flat in vec3 vColor; flat in vec3 vMark; in vec3 vRay; flat in vec3 vCenter; flat in vec4 vTurn; flat in float vRadius;
uniform mat4 projectionMatrix;
${turn}${shade}${surface}${finish}
void main() {
  vec3 ray = normalize(vRay);
  float along = dot(ray, vCenter);
  // How far the ray passes from the middle, in radii, and over how much of that a pixel spreads.
  float passes = sqrt(max(dot(vCenter, vCenter) - along * along, 0.0)) / vRadius;
  float pixel = max(fwidth(passes), 1e-6);
  float cover = clamp((1.0 - passes) / pixel + 0.5, 0.0, 1.0);
  if (cover <= (uPick > 0.5 ? 0.5 : 0.0)) discard;
  vec3 hit = (along - vRadius * sqrt(max(1.0 - passes * passes, 0.0))) * ray;
  mat3 toWorld = transpose(mat3(viewMatrix));
  vec3 normal = normalize(toWorld * ((hit - vCenter) / vRadius));
  vec3 own = turn(vec4(-vTurn.xyz, vTurn.w), normal);
  vec3 color = surface(vColor, vMark.z, own, vMark.x) * (own.x * own.y * own.z > 0.0 ? 1.0 : 0.82);
  vec3 world = toWorld * hit + cameraPosition;
  fragment = finish(color, normal, -(toWorld * ray), world, vMark.x, vMark.y, vMark.z, 0.0);
  if (uPick < 0.5) fragment.a *= cover;
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}`;

/** What the light sees of a shape, its far side: so that a lit face is never in its own shadow. Glass throws none. */
export const solidShadowVertex = `${instance}${turn}
void main() {
  readShape();
  vec3 world = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

/** Of a box the three faces on the other side. */
export const boxShadowVertex = `${instance}${turn}
uniform vec3 uLight;
void main() {
  readShape();
  vec3 light = turn(vec4(-iOrientation.xyz, iOrientation.w), uLight);
  vec3 own = position * vec3(light.x < 0.0 ? 1.0 : -1.0, light.y < 0.0 ? 1.0 : -1.0, light.z < 0.0 ? 1.0 : -1.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(iPosition + turn(iOrientation, own * iScale), 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

/** Of a ball the disc through its middle across the light. */
export const ballShadowVertex = `${instance}
uniform vec3 uLight;
out vec2 vAcross;
void main() {
  readShape();
  vAcross = position.xy;
  vec3 x = normalize(cross(abs(uLight.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), uLight));
  vec3 world = iPosition + iScale.x * (position.x * x + position.y * cross(uLight, x));
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

export const shadowFragment = `
out vec4 fragment;
void main() { fragment = vec4(1.0); }`;

export const ballShadowFragment = `
in vec2 vAcross; out vec4 fragment;
void main() {
  if (dot(vAcross, vAcross) > 1.0) discard;
  fragment = vec4(1.0);
}`;

/** A ground with lines of its body's frame that fades with the distance from where the bodies are. */
export const groundVertex = `
out vec2 vPlace; out vec3 vWorld;
void main() {
  vPlace = position.xy;
  vWorld = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const groundFragment = `
in vec2 vPlace; in vec3 vWorld; out vec4 fragment;
${shadow}
uniform vec3 uColor; uniform vec3 uLine; uniform float uCell; uniform float uReach; uniform vec2 uShift;
float lines(vec2 place, float cell) {
  vec2 at = place / cell;
  vec2 width = fwidth(at);
  vec2 off = abs(fract(at - 0.5) - 0.5) / max(width, 1e-6);
  vec2 seen = (1.0 - min(off, 1.0)) * (1.0 - smoothstep(0.2, 0.6, width));
  return max(seen.x, seen.y);
}
void main() {
  vec2 place = vPlace + uShift;
  float line = max(0.35 * lines(place, uCell), 0.8 * lines(place, 10.0 * uCell));
  float fade = 1.0 - smoothstep(0.35, 1.0, length(vPlace) / uReach);
  float light = mix(0.66, 1.0, lightAt(vWorld, vec3(0.0)));
  fragment = vec4(mix(uColor, uLine, line) * light, 0.96 * fade);
}`;

/** Depth of a point as if it were so much nearer to the eye [m]: what it lies in does not hide it, what is in front of that does. */
const nearer = `
uniform float uBias;
vec4 nearer(vec3 world) {
  vec4 clip = projectionMatrix * viewMatrix * vec4(world, 1.0);
  vec4 eye = viewMatrix * vec4(world, 1.0);
  eye.xyz *= max(1.0 - min(uBias, 1e30) / max(length(eye.xyz), 1e-9), 0.02);
  vec4 moved = projectionMatrix * eye;
  return vec4(clip.xy, moved.z / moved.w * clip.w, clip.w);
}`;

/** Arrows keep their thickness on the screen; heads are never longer than half the arrow. */
export const arrowVertex = `${nearer}
in float part; in vec3 iStart; in vec3 iVector; in vec3 iColor;
uniform float uPixel;
out vec3 vColor;
void main() {
  float size = length(iVector);
  vec3 z = size > 0.0 ? iVector / size : vec3(0, 0, 1);
  vec3 x = normalize(cross(abs(z.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), z));
  vec3 y = cross(z, x);
  float pixel = uPixel * max(-(viewMatrix * vec4(iStart, 1.0)).z, 1e-6);
  float head = min(11.0 * pixel, 0.5 * size);
  float width = part > 0.5 ? 4.2 * head / 11.0 : min(1.3 * pixel, 0.1 * size);
  float along = part > 0.5 ? size - head + position.z * head : position.z * (size - 0.8 * head);
  vec3 world = iStart + along * z + width * (position.x * x + position.y * y);
  vColor = iColor * (0.75 + 0.25 * position.x);
  gl_Position = nearer(world);
}`;

export const arrowFragment = `
in vec3 vColor; out vec4 fragment;
void main() { fragment = vec4(vColor, 1.0); }`;

/** Discs as large as so much of a body, but no smaller than can be seen and no larger than `most` pixels. */
export const pointVertex = `${nearer}
in vec3 color;
out vec3 vColor;
uniform float uRatio; uniform float uPixel; uniform float uDot; uniform float uMost;
void main() {
  vColor = color;
  float away = max(-(viewMatrix * vec4(position, 1.0)).z, 1e-6);
  gl_PointSize = uRatio * clamp(uDot / (uPixel * away), min(3.0, uMost), uMost);
  gl_Position = nearer(position);
}`;

export const pointFragment = `
in vec3 vColor; out vec4 fragment;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0) discard;
  fragment = vec4(r > 0.68 ? vec3(0.05) : vColor, 1.0);
}`;
