import { auditRows, auditText, auditWarnings, isSound } from "./audit_rows";
import { overlayColors } from "./colors";
import type { Contact } from "./contacts";
import { el } from "./dom";
import * as format from "./format";
import type { Motion } from "./frames";
import type { Header } from "./header";
import { add, orientationAt, turned, vectorAt, type Shown } from "./marks";
import { energyNow } from "./plots";
import type { MotionEvent } from "./run";
import type { FrameSource } from "./source";

export interface PanelActions {
  select(body: number): void;
  follow(body: number): void;
  changed(): void;
  showDeepest(): void;
}

/** Names found by the search beyond these are counted, not listed. */
const mostFound = 200;

/** Beside the scene: the chosen body's numbers, the search, what is shown, the audit. */
export class Panel {
  readonly element: HTMLElement;
  readonly search: HTMLInputElement;
  private readonly found = el("ul", { class: "found", "aria-label": "Bodies", tabindex: 0 });
  private readonly heat = el("p", { class: "heat-scale", hidden: true });
  private selected = -1;
  private readonly numbers = el("div", { class: "numbers", id: "numbers" });
  private readonly event = el("div", { class: "event", id: "event", role: "status" });
  private readonly audit = el("div");
  private readonly precision = el("p", { class: "hint" });
  private readonly boxes = new Map<keyof Shown, HTMLInputElement>();

  constructor(private source: FrameSource, private readonly shown: Shown, hasGhost: boolean, private readonly actions: PanelActions, control?: HTMLElement) {
    this.search = el("input", { type: "search", id: "search", placeholder: "Find a body by name (/)", "aria-label": "Find a body by name", oninput: () => this.list(), onkeydown: (event: KeyboardEvent) => this.searchKey(event) });
    const tabs: [string, HTMLElement][] = [
      // A live run has no audit yet; there one can change the scene.
      ...(control ? [["Control", control] as [string, HTMLElement]] : []),
      ["Body", el("div", { class: "bodies" }, this.search, this.found, this.numbers)],
      ["Show", this.showTab(hasGhost)],
      ...(control ? [] : [["Audit", this.audit] as [string, HTMLElement]]),
    ];
    this.element = el("aside", { class: "panel", "aria-label": "Bodies, view and audit" }, this.event, tabBar(tabs), ...tabs.map(([, content]) => content));
    this.setSource(source);
  }

  /** From now on it tells of this run. */
  setSource(source: FrameSource): void {
    this.source = source;
    const { position_error, orientation_error } = source.header;
    this.precision.textContent = `Positions are stored to ${format.number(position_error, 2)} m, orientations to ${format.number(orientation_error, 2)} rad. `
      + "Between two frames a body follows a smooth curve through both, over an impact two curves that meet there.";
    this.audit.replaceChildren(auditTable(source.header, this.actions));
    this.list();
  }

  /** Puts the boxes to what is shown now. */
  updateShown(): void {
    for (const [name, box] of this.boxes) box.checked = Boolean(this.shown[name]);
  }

  showEvent(event: MotionEvent | undefined): void {
    this.event.hidden = event === undefined;
    if (!event) return;
    const name = (body: number) => this.source.header.bodies[body]?.name ?? "";
    this.event.replaceChildren(
      el("h2", {}, el("span", { class: "dot", style: `background:${overlayColors.impulse}` }), `${event.kind} at ${format.number(event.time, 10)} s`),
      el("p", {}, bodyLink(event.bodyA, name(event.bodyA), this.actions), " ↔ ", bodyLink(event.bodyB, name(event.bodyB), this.actions)),
      table([
        ["impulse", `${format.number(Math.hypot(...event.impulse), 6)} N s`],
        [`on ${name(event.bodyB)}`, `[${format.vector(event.impulse, 5)}] N s`],
        ["at", `[${format.vector(event.point, 5)}] m`],
      ]));
  }

  /** The numbers of the chosen body at this moment. */
  showBody(body: number, motion: Motion, contacts: Contact[], followed: number): void {
    this.choose(body);
    if (body < 0) {
      this.numbers.replaceChildren(el("p", { class: "hint", text: "Click a body in the scene, or choose one here, to see its numbers." }));
      return;
    }
    const { header } = this.source;
    const own = header.bodies[body];
    const q = orientationAt(motion, body);
    const center = add(vectorAt(motion.position, body), header.origin);
    const v = vectorAt(motion.velocity, body), w = vectorAt(motion.spin, body);
    const [translation, rotation] = energyNow(this.source, body, motion);
    const g = header.gravity;
    // What is stored no finer than this is not told any finer.
    const known = (x: number) => (Math.abs(x) < header.position_error ? 0 : x);
    const rows: [string, string][] = [
      ["position", `[${format.vector(add(center, turned(q, own.frame.p)).map(known))}] m`],
      ["centre of mass", `[${format.vector(center.map(known))}] m`],
      ["orientation", `[${format.vector(product(q, own.frame.q))}]`],
      ["velocity", `[${format.vector(v)}] m/s`],
      ["speed", `${format.number(Math.hypot(...v))} m/s`],
      ["angular velocity", `[${format.vector(w)}] rad/s`],
    ];
    const touching = contacts.filter(({ bodyA, bodyB }) => bodyA === body || bodyB === body);
    if (own.mass > 0) {
      const weight = own.mass * Math.hypot(...g);
      if (weight > 0) rows.push(["weight", `${format.number(weight)} N`], ["held by", this.holders(body, touching)]);
      rows.push(
        ["mass", `${format.number(own.mass)} kg`],
        ["principal moments", `[${format.vector(own.moments)}] kg m²`],
        ["kinetic energy", `${format.number(translation + rotation)} J (turning ${format.number(rotation)})`],
        ["height energy", `${format.number(-own.mass * (g[0] * center[0] + g[1] * center[1] + g[2] * center[2]))} J`]);
    }
    rows.push(["contacts", String(touching.length)]);
    this.numbers.replaceChildren(
      el("h2", {}, own.name, el("small", { text: ` ${own.motion}` }),
        el("button", { type: "button", class: followed === body ? "on" : "", title: "The camera goes along (F)", onclick: () => this.actions.follow(body) }, "follow")),
      table(rows), this.contactTable(body, touching));
  }

  /** Which bodies and joints carry the body against gravity, and what the contacts carry [N]. */
  private holders(body: number, touching: Contact[]): string {
    const { gravity, bodies, joints, springs } = this.source.header;
    const strength = Math.hypot(...gravity);
    const carried = new Map<string, number>();
    let isKnown = true;
    for (const { bodyA, bodyB, force, mode } of touching) {
      isKnown &&= mode !== "unknown";
      const up = force.reduce((sum, f, c) => sum - (f * gravity[c]) / strength, 0) * (bodyB === body ? 1 : -1);
      const { name } = bodies[bodyA === body ? bodyB : bodyA];
      carried.set(name, (carried.get(name) ?? 0) + up);
    }
    const least = 1e-3 * bodies[body].mass * strength;
    const held = [...carried].filter(([, up]) => up > least).sort((a, b) => b[1] - a[1]).map(([name, up]) => `${name} ${format.number(up)} N`);
    held.push(...joints.filter((joint) => joint.bodies.includes(body)).map(({ name, type }) => name || type));
    if (springs.some((spring) => spring.bodies.includes(body))) held.push("a spring");
    if (held.length === 0) return touching.length > 0 && !isKnown ? "contacts (forces not known)" : "nothing: it falls or flies";
    return held.slice(0, 6).join(", ") + (held.length > 6 ? ` and ${held.length - 6} more` : "");
  }

  private contactTable(body: number, contacts: Contact[]): HTMLElement | string {
    if (contacts.length === 0) return "";
    const rows = contacts.slice(0, 50).map(({ bodyA, bodyB, force, normal, mode, gap }) => {
      const other = bodyA === body ? bodyB : bodyA;
      const along = force[0] * normal[0] + force[1] * normal[1] + force[2] * normal[2];
      const across = Math.hypot(...force.map((f, c) => f - along * normal[c]));
      const isKnown = mode !== "unknown";
      return el("tr", {}, el("td", {}, this.source.header.bodies[other].name), el("td", {}, mode),
        el("td", {}, isKnown ? format.number(along, 4) : "–"), el("td", {}, isKnown ? format.number(across, 3) : "–"), el("td", {}, format.number(gap, 2)));
    });
    const head = ["with", "mode", "normal [N]", "friction [N]", "gap [m]"].map((text) => el("th", { scope: "col", text }));
    return el("table", { class: "contacts" }, el("tr", {}, ...head), ...rows);
  }

  private list(): void {
    const wanted = this.search.value.trim().toLowerCase();
    const { bodies } = this.source.header;
    const found = bodies.flatMap((body, i) => (body.name.toLowerCase().includes(wanted) ? [i] : []));
    this.found.replaceChildren(...found.slice(0, mostFound).map((i) =>
      el("li", { "data-body": i }, el("button", { type: "button", "aria-pressed": String(i === this.selected), onclick: () => this.actions.select(i) }, bodies[i].name, el("small", { text: ` ${bodies[i].motion}` })))));
    if (found.length === 0) this.found.append(el("li", { class: "hint", text: "no body has this in its name" }));
    if (found.length > mostFound) this.found.append(el("li", { class: "hint", text: `and ${found.length - mostFound} more` }));
  }

  /** Enter chooses the first body that was found, an arrow goes on to the list. */
  private searchKey(event: KeyboardEvent): void {
    const first = this.found.querySelector("button");
    if (!first || (event.key !== "Enter" && event.key !== "ArrowDown")) return;
    event.preventDefault();
    if (event.key === "Enter") first.click();
    else first.focus();
  }

  /** Marks the chosen body in the list. */
  private choose(body: number): void {
    if (body === this.selected) return;
    this.selected = body;
    for (const item of this.found.querySelectorAll<HTMLElement>("li[data-body]")) {
      const isChosen = Number(item.dataset.body) === body;
      item.firstElementChild?.setAttribute("aria-pressed", String(isChosen));
      // The list alone scrolls, not the page.
      if (isChosen) requestAnimationFrame(() => {
        const { scrollTop, clientHeight } = this.found;
        if (item.offsetTop < scrollTop || item.offsetTop + item.offsetHeight > scrollTop + clientHeight) this.found.scrollTop = item.offsetTop;
      });
    }
  }

  /** What the colours of the heat map stand for: up to this force [N]. */
  showHeat(hottest: number | undefined): void {
    this.heat.hidden = hottest === undefined;
    if (hottest !== undefined) this.heat.replaceChildren("0", el("span", { class: "heat" }), `${format.number(hottest)} N pressed on a body`);
  }

  private showTab(hasGhost: boolean): HTMLElement {
    const { header } = this.source;
    const entries: [keyof Shown, string, string[], boolean][] = [
      ["contacts", "Contact points and forces (C)", [overlayColors.normal, overlayColors.stick, overlayColors.slide], true],
      ["velocities", "Velocities (V)", [overlayColors.velocity], true],
      ["frames", "Body frames (X)", [overlayColors.x, overlayColors.y, overlayColors.z], true],
      ["inertia", "Axes of inertia (I)", [overlayColors.x, overlayColors.y, overlayColors.z], true],
      ["joints", "Joints and their axes (J)", [overlayColors.impulse], header.joints.length > 0],
      ["trails", "Trails (T)", [overlayColors.normal], true],
      ["penetration", "Overlapping bodies (P)", [overlayColors.penetration], true],
      ["ghost", "Run B as a ghost (G)", [], hasGhost],
      ["heat", "Forces as a heat map (M)", ["#29336b", "#cc475c", "#fce06b"], true],
      ["shadows", "Shadows (H)", [], true],
    ];
    const lines = entries.filter(([, , , exists]) => exists).map(([name, text, colors]) => {
      const box = el("input", { type: "checkbox", id: `show-${name}`, onchange: () => {
        (this.shown[name] as boolean) = box.checked;
        this.shown.chosen.add(name);
        this.actions.changed();
      } });
      this.boxes.set(name, box);
      return el("label", {}, box, ...colors.map((color) => el("span", { class: "dot", style: `background:${color}` })), text);
    });
    const scale = el("input", { type: "range", min: -2, max: 2, step: 0.1, value: 0, "aria-label": "Length of arrows", oninput: () => {
      this.shown.arrowScale = 2 ** Number(scale.value);
      this.actions.changed();
    } });
    const legend = (text: string, color: string) => el("span", {}, el("span", { class: "dot", style: `background:${color}` }), text);
    return el("div", { class: "show" }, ...lines, this.heat, el("label", {}, "Length of arrows ", scale),
      el("p", { class: "legend" }, legend("normal force", overlayColors.normal), legend("friction, sticks", overlayColors.stick),
        legend("friction, slides", overlayColors.slide), legend("no force", overlayColors.open), legend("impulse", overlayColors.impulse)),
      this.precision);
  }
}

function product(a: readonly number[], b: readonly number[]): number[] {
  const [w, x, y, z] = a, [s, p, q, r] = b;
  return [w * s - x * p - y * q - z * r, w * p + x * s + y * r - z * q, w * q - x * r + y * s + z * p, w * r + x * q - y * p + z * s];
}

function bodyLink(body: number, name: string, actions: PanelActions): HTMLElement {
  return el("button", { type: "button", class: "link", onclick: () => actions.select(body) }, name || "–");
}

function table(rows: [string, string | Node][]): HTMLElement {
  return el("table", {}, ...rows.map(([name, value]) => el("tr", {}, el("th", { scope: "row", text: name }), el("td", {}, value))));
}

function tabBar(tabs: [string, HTMLElement][]): HTMLElement {
  const buttons = tabs.map(([name], i) => el("button", { type: "button", role: "tab", id: `tab-${i}`, "aria-controls": `tab-content-${i}`, onclick: () => choose(i) }, name));
  const choose = (chosen: number) => tabs.forEach(([, content], i) => {
    content.hidden = i !== chosen;
    buttons[i].setAttribute("aria-selected", String(i === chosen));
    buttons[i].tabIndex = i === chosen ? 0 : -1;
  });
  tabs.forEach(([, content], i) => {
    content.classList.add("tab");
    for (const [name, value] of Object.entries({ role: "tabpanel", id: `tab-content-${i}`, "aria-labelledby": `tab-${i}` })) content.setAttribute(name, value);
  });
  choose(0);
  // Arrows go from tab to tab.
  const turn = (event: KeyboardEvent) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (buttons.indexOf(event.target as HTMLButtonElement) + step + tabs.length) % tabs.length;
    choose(next);
    buttons[next].focus();
  };
  return el("div", { class: "tabs", role: "tablist", "aria-label": "Panel", onkeydown: turn }, ...buttons);
}

/** The audit, line by line, what broke its tolerance first. */
function auditTable({ audit }: Header, actions: PanelActions): HTMLElement {
  const rows = auditRows(audit).map(({ name, value }): [string, string | Node] => [name, auditValue(name, value, actions)]);
  return el("div", {},
    el("p", { class: isSound(audit) ? "sound" : "broken", text: isSound(audit) ? "✓ audit passed" : "✗ audit violated" }),
    ...auditWarnings(audit).map((warning) => el("p", { class: "warning", text: warning })),
    table(rows));
}

function auditValue(name: string, value: unknown, actions: PanelActions): string | Node {
  if (name !== "penetration: time" || typeof value !== "number") return auditText(value);
  return el("button", { type: "button", class: "link", title: "Go there", onclick: () => actions.showDeepest() }, `${auditText(value)} s`);
}
