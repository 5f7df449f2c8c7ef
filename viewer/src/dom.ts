type Child = Node | string | undefined;

/** What drives the direction of writing or is no character to see: names with it must not look like others. */
const deceptive = /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069]/g;

/** A text of the data as it is shown: \u202e instead of what would turn the line. */
export function shown(text: string): string {
  return text.replace(deceptive, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);
}

/** An element with its attributes (on... are listeners, class and text are short for what they say) and children. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, unknown> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    // The page's policy forbids style attributes, not styles that a script sets.
    else if (name === "style") element.style.cssText = String(value);
    else if (name === "text") element.textContent = shown(String(value));
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) {
    if (child !== undefined) element.append(typeof child === "string" ? shown(child) : child);
  }
  return element;
}

/** A button with a tooltip that is also its spoken name; that has the words that are written on it. */
export function button(text: string, title: string, act: () => void): HTMLButtonElement {
  const words = text.replace(/[^\p{L}\p{N} ]/gu, "").trim();
  const isSaid = title.toLowerCase().includes(words.toLowerCase());
  return el("button", { type: "button", title, "aria-label": isSaid ? title : `${words}: ${title}`, onclick: act }, text);
}
