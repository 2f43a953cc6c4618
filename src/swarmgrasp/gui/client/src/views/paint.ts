/* What the canvases share: colours of the theme, sharp pixels, and when to draw again. */

const NAMES = [
  "page", "card", "wash", "ink", "ink2", "grey", "line", "hull", "hull-line", "robot", "new",
  "new-text", "good", "bad", "weak", "next", "zone", "low", "middle", "high",
  "side-0", "side-1", "side-2",
] as const;

export type Palette = { readonly [name in (typeof NAMES)[number]]: string };

/** Colours as they were read, and of which theme. */
const read = new WeakMap<Element, { readonly theme: string; readonly colours: Palette }>();

/** The colours that the theme of its widget gives to an element; read again when the theme is another. */
export function palette(node: Element): Palette {
  const dark = globalThis.matchMedia("(prefers-color-scheme: dark)").matches;
  const theme = `${node.closest("[data-theme]")?.getAttribute("data-theme") ?? ""} ${dark}`;
  const known = read.get(node);
  if (known?.theme === theme) return known.colours;
  const colours = readPalette(node, dark);
  read.set(node, { theme, colours });
  return colours;
}

function readPalette(node: Element, systemIsDark: boolean): Palette {
  const style = getComputedStyle(node);
  const isDark = style.colorScheme.includes(" ") ? systemIsDark : style.colorScheme === "dark";
  return Object.fromEntries(NAMES.map((name) => {
    const both = style.getPropertyValue(`--${name}`).match(/#[0-9a-f]{6}/gi);
    return [name, both?.[isDark ? 1 : 0] ?? both?.[0] ?? "#000000"];
  })) as Palette;
}

/** A colour "#rrggbb" with an opacity, or as it is. */
export function faint(colour: string, opacity: number): string {
  const share = Math.round(255 * Math.min(Math.max(opacity, 0), 1)).toString(16).padStart(2, "0");
  return /^#[0-9a-f]{6}$/i.test(colour) ? colour + share : colour;
}

export type Rgb = readonly [number, number, number];

/** "#rrggbb" as three numbers of 0 to 255. */
export function rgb(colour: string): Rgb {
  const value = Number.parseInt(colour.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** The colour so far along a ramp of three; `share` of 0 to 1. */
export function ramp(low: Rgb, middle: Rgb, high: Rgb, share: number): Rgb {
  const [from, to, along] = share < 0.5 ? [low, middle, 2 * share] : [middle, high, 2 * share - 1];
  return [0, 1, 2].map((i) => Math.round(from[i]! + (to[i]! - from[i]!) * along)) as unknown as Rgb;
}

export interface Sheet {
  readonly pen: CanvasRenderingContext2D;
  readonly width: number;
  readonly height: number;
}

/** A canvas of the size of its box, cleared, in CSS pixels; null where there is no room. */
export function sheet(canvas: HTMLCanvasElement): Sheet | null {
  const { clientWidth: width, clientHeight: height } = canvas;
  const scale = globalThis.devicePixelRatio || 1;
  const [wide, high] = [Math.round(width * scale), Math.round(height * scale)];
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  const pen = canvas.getContext("2d");
  if (pen === null || wide === 0 || high === 0) return null;
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, width, height);
  return { pen, width, height };
}

/** Draws again when a box changes its size or the theme its colours. */
export function whenLooksChange(root: HTMLElement, box: Element, draw: () => void): void {
  new ResizeObserver(draw).observe(box);
  new MutationObserver(draw).observe(root, { attributes: true, attributeFilter: ["data-theme"] });
  globalThis.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
}
