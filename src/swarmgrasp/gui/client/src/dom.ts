/* Elements by name, never by text: the content policy allows no markup from strings. */

export type Attributes = Readonly<Record<string, string | number | boolean | null>>;
type Child = Node | string | null;

const SVG = "http://www.w3.org/2000/svg";

function dressed<E extends Element>(node: E, attributes: Attributes, children: readonly Child[]): E {
  put(node, attributes);
  for (const child of children) if (child !== null) node.append(child);
  return node;
}

/** An HTML element with attributes and children. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  return dressed(document.createElement(tag), attributes, children);
}

/** An SVG element with attributes and children. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: Child[]
): SVGElementTagNameMap[K] {
  return dressed(document.createElementNS(SVG, tag), attributes, children);
}

/** Sets attributes that differ; null and false take one away. */
export function put(node: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false) {
      if (node.hasAttribute(name)) node.removeAttribute(name);
    } else {
      const text = value === true ? "" : String(value);
      if (node.getAttribute(name) !== text) node.setAttribute(name, text);
    }
  }
}

/** Sets the text of a node where it differs. */
export function write(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

/** Shows or hides. */
export function show(node: HTMLElement | SVGElement, visible: boolean): void {
  put(node, { hidden: !visible });
}

/** Nodes that are kept from one drawing to the next, one for each item. */
export class Pool<E extends Element, T> {
  readonly #nodes: E[] = [];

  constructor(
    readonly parent: Element,
    readonly make: () => E,
    readonly dress: (node: E, item: T, index: number) => void,
  ) {}

  get nodes(): readonly E[] {
    return this.#nodes;
  }

  draw(items: readonly T[]): void {
    while (this.#nodes.length > items.length) this.#nodes.pop()?.remove();
    while (this.#nodes.length < items.length) {
      const node = this.make();
      this.#nodes.push(node);
      this.parent.append(node);
    }
    items.forEach((item, i) => this.dress(this.#nodes[i]!, item, i));
  }
}

const ICONS: Readonly<Record<string, readonly string[]>> = {
  undo: ["M8 5 4 9l4 4", "M4 9h7a5 5 0 0 1 0 10H9"],
  redo: ["m12 5 4 4-4 4", "M16 9H9A5 5 0 0 0 9 19h2"],
  share: ["M10 13V3", "m6 7 4-4 4 4", "M4 11v6h12v-6"],
  text: ["m7 6-4 4 4 4", "m13 6 4 4-4 4"],
  theme: ["M10 3a7 7 0 1 0 0 14 7 7 0 0 0 0-14Z", "M10 3v14a7 7 0 0 0 0-14Z"],
  help: ["M7.5 7.5a2.5 2.5 0 1 1 3.4 2.4c-.6.3-.9.8-.9 1.6", "M10 14.6v.1"],
  down: ["m6 8 4 4 4-4"],
  plus: ["M10 4v12", "M4 10h12"],
  copy: ["M7 7h9v9H7z", "M13 7V4H4v9h3"],
  remove: ["M4 6h12", "M8 6V4h4v2", "M6 6l1 11h6l1-11"],
  close: ["m5 5 10 10", "M15 5 5 15"],
};

/** A drawn sign of 20 px, for a button that has a name of its own. */
export function icon(name: string): SVGSVGElement {
  const drawn = svg("svg", { viewBox: "0 0 20 20", width: 20, height: 20, class: `icon icon-${name}`, "aria-hidden": "true" });
  for (const d of ICONS[name] ?? []) drawn.append(svg("path", { d }));
  return drawn;
}

/** A button with a sign, named for those who hear the page and on hover. */
export function iconButton(name: string, label: string, run: () => void): HTMLButtonElement {
  const button = el("button", { type: "button", class: "icon-button", "aria-label": label, title: label }, icon(name));
  button.addEventListener("click", run);
  return button;
}
