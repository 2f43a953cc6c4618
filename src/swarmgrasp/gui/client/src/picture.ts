/* The plan as a picture by itself: every colour and font written where it is used. */

const KEPT = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linecap",
  "stroke-linejoin", "opacity", "font-family", "font-size", "font-weight", "text-anchor", "dominant-baseline",
] as const;
const UNSEEN = ".grab, .layer-handles, [hidden]";

/** The text of an SVG file of a drawing on the page. */
export function svgOf(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const [from, to] = [[drawing, ...drawing.querySelectorAll("*")], [copy, ...copy.querySelectorAll("*")]];
  from.forEach((node, i) => {
    const style = getComputedStyle(node);
    for (const name of KEPT) {
      const value = style.getPropertyValue(name);
      if (value !== "" && value !== "auto") to[i]!.setAttribute(name, plain(value));
    }
  });
  copy.querySelectorAll(UNSEEN).forEach((node) => node.remove());
  for (const node of [copy, ...copy.querySelectorAll("*")]) {
    for (const { name } of [...node.attributes]) {
      if (/^(class|role|tabindex|data-.*|aria-.*)$/.test(name)) node.removeAttribute(name);
    }
  }
  const ground = getComputedStyle(drawing.parentElement!).backgroundColor;
  const back = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of [["width", "100%"], ["height", "100%"], ["fill", plain(ground)]] as const) back.setAttribute(name, value);
  copy.prepend(back);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  return new XMLSerializer().serializeToString(copy);
}

/** Colours as other programs read them. */
function plain(value: string): string {
  return value.replaceAll(/color\(srgb ([\d.e-]+) ([\d.e-]+) ([\d.e-]+)(?: \/ [\d.]+)?\)/g, (_, r: string, g: string, b: string) =>
    `#${[r, g, b].map((part) => Math.round(255 * Math.max(0, Math.min(1, Number(part)))).toString(16).padStart(2, "0")).join("")}`);
}

/** A PNG file of an SVG text, two pixels for one. */
export async function pngOf(text: string): Promise<Blob> {
  const picture = new Image();
  const url = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  try {
    await new Promise<void>((done, failed) => {
      picture.onload = () => done();
      picture.onerror = () => failed(new Error("The picture cannot be drawn."));
      picture.src = url;
    });
    const canvas = document.createElement("canvas");
    canvas.width = 2 * picture.naturalWidth;
    canvas.height = 2 * picture.naturalHeight;
    canvas.getContext("2d")!.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return await new Promise<Blob>((done, failed) =>
      canvas.toBlob((blob) => (blob === null ? failed(new Error("The picture is too large.")) : done(blob)), "image/png"));
  } finally {
    URL.revokeObjectURL(url);
  }
}
