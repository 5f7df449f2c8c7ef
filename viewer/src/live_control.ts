import { button, el } from "./dom";
import * as format from "./format";
import type { Header, Vec } from "./header";
import type { LiveAxis, LiveCommand, LiveStatus } from "./live_message";

/** Beyond these materials only the first are listed. */
const mostMaterials = 50;

interface Slider {
  element: HTMLElement;
  input: HTMLInputElement;
  set(value: number): void;
}

/** The tab with which a live scene is changed. It shows what the simulation tells, not what was asked of it. */
export class LiveControl {
  readonly element = el("div", { class: "control" });
  private readonly errors = el("div", { class: "errors", role: "alert" });
  private readonly fileNote = el("p", { class: "hint", id: "file" });
  private readonly follow: HTMLInputElement;
  private readonly settings = el("div");
  private readonly setters: ((status: LiveStatus) => void)[] = [];
  private readonly down: Vec;
  private isBuilt = false;

  constructor(header: Header, private readonly send: (command: LiveCommand) => void) {
    const strength = Math.hypot(...header.gravity);
    this.down = strength > 0 ? (header.gravity.map((g) => g / strength) as Vec) : [0, 0, -1];
    this.follow = el("input", { type: "checkbox", id: "follow", onchange: () => send({ do: "follow", value: this.follow.checked }) });
    this.element.append(this.errors, this.settings, el("h2", { text: "Scene file" }), this.fileNote,
      el("label", {}, this.follow, "Read it again when it changes"),
      button("Read it now", "Read the scene file again, from t = 0", () => send({ do: "reload" })));
  }

  showErrors(messages: string[]): void {
    this.errors.replaceChildren(...messages.map((message) => el("p", { class: "warning", text: message })));
  }

  update(status: LiveStatus): void {
    if (!this.isBuilt) this.build(status);
    for (const set of this.setters) set(status);
    const { name, follow, changed, messages } = status.file;
    this.follow.checked = follow;
    const errors = messages.map((message) => el("span", { class: "warning", text: message }));
    this.fileNote.replaceChildren(name, changed ? " has changed" : "", ...errors.flatMap((line) => [el("br"), line]));
  }

  private build(status: LiveStatus): void {
    this.isBuilt = true;
    const gravity = slider("Gravity", "m/s²", "gravity", [0, 30, 0.01], (value) => this.send({ do: "gravity", value: this.down.map((d) => d * value) as Vec }));
    this.setters.push((now) => gravity.set(Math.hypot(...now.gravity)));
    this.settings.append(el("h2", { text: "World" }), gravity.element, this.stepField());
    if (status.axes.length > 0) this.settings.append(el("h2", { text: "Joints" }), ...status.axes.flatMap((axis, i) => this.axisFields(axis, i)));
    this.settings.append(el("h2", { text: "Materials" }));
    status.surfaces.slice(0, mostMaterials).forEach(({ material }, i) => {
      const friction = slider(`${material}: friction`, "", `friction-${i}`, [0, 2, 0.01], (value) => this.send({ do: "surface", material, friction: value }));
      const restitution = slider(`${material}: restitution`, "", `restitution-${i}`, [0, 1, 0.01], (value) => this.send({ do: "surface", material, restitution: value }));
      this.setters.push((now) => {
        friction.set(now.surfaces[i].friction);
        restitution.set(now.surfaces[i].restitution);
      });
      this.settings.append(friction.element, restitution.element);
    });
    this.settings.append(el("p", { class: "hint", text: "Pairs of materials that the scene gives values of their own keep them." }), el("h2", { text: "Method" }));
    status.method.forEach((choice, i) => {
      const select = el("select", { id: `method-${choice.key}`, disabled: choice.values.length < 2, onchange: () => this.send({ do: "method", key: choice.key, value: select.value }) },
        ...choice.values.map((value) => el("option", { value }, value)));
      this.setters.push((now) => (select.value = now.method[i]?.value ?? ""));
      this.settings.append(el("label", {}, el("span", { class: "name", text: choice.key }), select));
    });
  }

  /** A motor for each coordinate of a joint, and where its spring rests if it has one. */
  private axisFields({ joint, coordinate, name, unit, rest }: LiveAxis, i: number): HTMLElement[] {
    const title = coordinate > 0 ? `${name} (${coordinate + 1})` : name;
    const reach = unit === "rad" ? 10 : 2;
    const motor = slider(`${title}: motor`, `${unit}/s`, `motor-${i}`, [-reach, reach, reach / 200], (velocity) => this.send({ do: "motor", joint, coordinate, velocity }));
    const isOn = el("input", { type: "checkbox", id: `motor-on-${i}`, "aria-label": `${title}: motor on`,
      onchange: () => this.send({ do: "motor", joint, coordinate, velocity: isOn.checked ? Number(motor.input.value) : undefined }) });
    motor.element.prepend(isOn);
    this.setters.push(({ axes }) => {
      isOn.checked = axes[i].motor !== null;
      if (axes[i].motor !== null) motor.set(axes[i].motor ?? 0);
    });
    motor.set(0);
    if (rest === null) return [motor.element];
    const half = unit === "rad" ? 3.14 : 1;
    const spring = slider(`${title}: spring rests at`, unit, `rest-${i}`, [-half, half, half / 157], (value) => this.send({ do: "rest", joint, coordinate, value }));
    this.setters.push(({ axes }) => spring.set(axes[i].rest ?? 0));
    return [motor.element, spring.element];
  }

  /** The target step as a field: its useful values spread over many powers of ten. */
  private stepField(): HTMLElement {
    const field = el("input", { type: "text", inputmode: "decimal", id: "target-step", onchange: () => this.send({ do: "target_step", value: Number(field.value) }) });
    this.setters.push((now) => {
      if (document.activeElement !== field) field.value = String(now.target_step);
    });
    return el("label", {}, el("span", { class: "name", text: "Target step [s]" }), field);
  }
}

/** A slider with its value beside it. While it is held, what the simulation tells does not move it. */
function slider(name: string, unit: string, id: string, [low, high, step]: [number, number, number], change: (value: number) => void): Slider {
  let isHeld = false;
  const value = el("output", {});
  const tell = (x: number) => (value.textContent = `${format.number(x, 4)} ${unit}`);
  const input = el("input", {
    type: "range", id, min: low, max: high, step, "aria-label": name,
    oninput: () => {
      tell(Number(input.value));
      change(Number(input.value));
    },
    onpointerdown: () => (isHeld = true), onpointerup: () => (isHeld = false), onpointercancel: () => (isHeld = false),
  });
  const set = (x: number) => {
    if (isHeld) return;
    if (x > Number(input.max)) input.max = String(x);
    if (x < Number(input.min)) input.min = String(x);
    input.value = String(x);
    tell(x);
  };
  return { element: el("label", { class: "slider" }, el("span", { class: "name", text: name }), input, value), input, set };
}
