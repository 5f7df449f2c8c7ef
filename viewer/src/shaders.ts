/** Turns a vector by a quaternion x y z w. */
const turn = `
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }`;

/** One light over the viewer's shoulder, the sky and what the ground throws back. */
const shade = `
uniform vec3 uUp;
vec3 shade(vec3 color, vec3 normal, vec3 toEye) {
  vec3 light = normalize(uUp * 0.8 + toEye * 0.8 + cross(uUp, toEye) * 0.45);
  float sky = 0.5 + 0.5 * dot(normal, uUp);
  float direct = max(dot(normal, light), 0.0);
  float gloss = pow(max(dot(normal, normalize(light + toEye)), 0.0), 40.0);
  return color * (0.36 + 0.24 * sky + 0.50 * direct) + 0.12 * gloss;
}`;

/** The body's number as a colour (picking), or what is seen; a mark of 1 is the selected body, of 2 an overlapping one. */
const finish = `
uniform float uPick;
uniform float uAlpha;
uniform vec4 uTint;
uniform vec3 uSelected;
uniform vec3 uWarning;
out vec4 fragment;
vec4 finish(vec3 color, vec3 normal, vec3 toEye, float body, float mark) {
  if (uPick > 0.5) return vec4(mod(body, 256.0), mod(floor(body / 256.0), 256.0), floor(body / 65536.0), 255.0) / 255.0;
  vec3 base = mix(color, uTint.rgb, uTint.a);
  vec3 lit = shade(base, normal, toEye);
  float rim = 1.0 - max(dot(normal, toEye), 0.0);
  if (mark > 1.5) lit = mix(lit, uWarning, 0.55);
  else if (mark > 0.5) lit = mix(lit, uSelected, 0.25 + 0.75 * smoothstep(0.45, 0.75, rim));
  return vec4(lit, uAlpha);
}`;

/** Width of the tables of shapes; each shape has two texels in one row. */
export const tableWidth = 2048;

/** Where a shape is (position and mark, orientation) and what it is like (scale and body, colour). */
const instance = `
in float shapeIndex;
uniform highp sampler2D uPose; uniform highp sampler2D uLook;
flat out vec3 vColor; flat out vec2 vMark;
vec3 iPosition; vec4 iOrientation; vec3 iScale;
void readShape() {
  int at = 2 * int(shapeIndex + 0.5);
  ivec2 first = ivec2(at % ${tableWidth}, at / ${tableWidth}), second = first + ivec2(1, 0);
  vec4 place = texelFetch(uPose, first, 0), size = texelFetch(uLook, first, 0);
  iPosition = place.xyz; iOrientation = texelFetch(uPose, second, 0); iScale = size.xyz;
  vColor = texelFetch(uLook, second, 0).rgb; vMark = vec2(size.w, place.w);
}`;

export const solidVertex = `${instance}${turn}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn;
void main() {
  readShape();
  vNormal = turn(iOrientation, normalize(normal / iScale));
  vOwn = position;
  vWorld = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

/** Of a box only the three faces on the eye's side are drawn: those of the corner (1, 1, 1), mirrored to where the eye is. */
export const boxVertex = `${instance}${turn}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn;
void main() {
  readShape();
  vec3 eye = turn(vec4(-iOrientation.xyz, iOrientation.w), cameraPosition - iPosition);
  vOwn = position * vec3(eye.x < 0.0 ? -1.0 : 1.0, eye.y < 0.0 ? -1.0 : 1.0, eye.z < 0.0 ? -1.0 : 1.0);
  vNormal = vec3(0.0);
  vWorld = iPosition + turn(iOrientation, vOwn * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

/** Quarters of round shapes alternate, so that turning is seen; flat ones take their normals from the drawn surface. */
export const solidFragment = `
flat in vec3 vColor; flat in vec2 vMark; in vec3 vNormal; in vec3 vWorld; in vec3 vOwn;
${shade}${finish}
uniform float uIsRound; uniform float uIsFlat;
void main() {
  vec3 normal = normalize(uIsFlat > 0.5 ? cross(dFdx(vWorld), dFdy(vWorld)) : vNormal);
  vec3 color = vColor * (uIsRound > 0.5 && vOwn.x * vOwn.y > 0.0 ? 0.82 : 1.0);
  fragment = finish(color, normal, normalize(cameraPosition - vWorld), vMark.x, vMark.y);
}`;

/** A square that just covers the ball as seen from the eye (view space, eye at the origin, perspective). */
export const ballVertex = `${instance}
out vec3 vRay; flat out vec3 vCenter; flat out vec4 vTurn; flat out float vRadius;
void main() {
  readShape();
  vTurn = iOrientation; vRadius = iScale.x;
  vCenter = (viewMatrix * vec4(iPosition, 1.0)).xyz;
  float d2 = dot(vCenter, vCenter);
  float reach = vRadius * sqrt(d2 / max(d2 - vRadius * vRadius, 1e-6 * d2));
  vec3 z = -vCenter / sqrt(d2);
  vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
  vRay = vCenter + reach * (position.x * x + position.y * cross(z, x));
  gl_Position = projectionMatrix * vec4(vRay, 1.0);
}`;

/** The ray meets the ball nearest to the eye; octants of the body frame alternate, so that turning is seen. */
export const ballFragment = `
flat in vec3 vColor; flat in vec2 vMark; in vec3 vRay; flat in vec3 vCenter; flat in vec4 vTurn; flat in float vRadius;
uniform mat4 projectionMatrix;
${turn}${shade}${finish}
void main() {
  vec3 ray = normalize(vRay);
  float along = dot(ray, vCenter);
  float under = vRadius * vRadius - dot(vCenter, vCenter) + along * along;
  if (under < 0.0) discard;
  vec3 hit = (along - sqrt(under)) * ray;
  mat3 toWorld = transpose(mat3(viewMatrix));
  vec3 normal = toWorld * ((hit - vCenter) / vRadius);
  vec3 own = turn(vec4(-vTurn.xyz, vTurn.w), normal);
  vec3 color = vColor * (own.x * own.y * own.z > 0.0 ? 1.0 : 0.78);
  fragment = finish(color, normal, -(toWorld * ray), vMark.x, vMark.y);
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}`;

/** The body's outline thrown on the plane n · x = d along the light. */
export const shadowVertex = `${instance}${turn}
uniform vec4 uPlane; uniform vec3 uLight;
void main() {
  readShape();
  vec3 world = iPosition + turn(iOrientation, position * iScale);
  float height = max(dot(uPlane.xyz, world) - uPlane.w, 0.0);
  world -= (height / dot(uPlane.xyz, uLight)) * uLight;
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
}`;

export const shadowFragment = `
flat in vec3 vColor; flat in vec2 vMark; out vec4 fragment;
void main() { fragment = vec4(0.0, 0.0, 0.0, 0.22); }`;

/** A ground with lines of its body's frame that fades with the distance from where the bodies are. */
export const groundVertex = `
out vec2 vPlace;
void main() {
  vPlace = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const groundFragment = `
in vec2 vPlace; out vec4 fragment;
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
  fragment = vec4(mix(uColor, uLine, line), 0.92 * fade);
}`;

/** Arrows keep their thickness on the screen; heads are never longer than half the arrow. */
export const arrowVertex = `
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
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
}`;

export const arrowFragment = `
in vec3 vColor; out vec4 fragment;
void main() { fragment = vec4(vColor, 1.0); }`;

export const pointVertex = `
in vec3 color; in float size;
out vec3 vColor;
uniform float uRatio;
void main() {
  vColor = color;
  gl_PointSize = size * uRatio;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const pointFragment = `
in vec3 vColor; out vec4 fragment;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0) discard;
  fragment = vec4(r > 0.68 ? vec3(0.05) : vColor, 1.0);
}`;
