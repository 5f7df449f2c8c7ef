type Child = Node | string | undefined;

/** An element with its attributes (on... are listeners, class and text are short for what they say) and children. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, unknown> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else if (name === "text") element.textContent = String(value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== undefined));
  return element;
}

/** A button with a tooltip that is also its spoken name. */
export function button(text: string, title: string, act: () => void): HTMLButtonElement {
  return el("button", { type: "button", title, "aria-label": title, onclick: act }, text);
}
