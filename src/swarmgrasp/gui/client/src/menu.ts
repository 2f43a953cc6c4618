/* The menu of scenes and files: open, save, share, export. */

import type { Context } from "./context";
import { el } from "./dom";
import { pngOf, svgOf } from "./picture";
import { toLink } from "./share";
import type { Sheet } from "./sheet";

/** Links longer than this are cut by some chat programs. */
const LONG_LINK = 2000;

export interface MenuActions {
  /** Opens a built-in scene. */
  readonly open: (name: string) => void;
  /** Reads a scenario from a text. */
  readonly read: (text: string, name: string) => void;
  readonly plan: () => SVGSVGElement;
  /** The text of what is on the page. */
  readonly text: () => Promise<string | null>;
}

export class Menu {
  readonly #file = el("input", { type: "file", accept: ".yaml,.yml,.json", hidden: true, "aria-label": "Scenario file" });

  constructor(readonly context: Context, readonly sheet: Sheet, readonly actions: MenuActions) {
    context.root.append(this.#file);
    this.#file.addEventListener("change", () => void this.#picked());
    context.root.addEventListener("dragover", (event) => event.preventDefault());
    context.root.addEventListener("drop", (event) => {
      const file = event.dataTransfer?.files[0];
      if (file === undefined) return;
      event.preventDefault();
      void file.text().then((text) => actions.read(text, file.name));
    });
  }

  show(opener: HTMLElement): void {
    const { welcome } = this.context.talk;
    const seen = this.context.store.seen.value;
    const scenes = (welcome.value?.scenes ?? []).map(({ name, title }) => {
      const item = this.#item(title, () => this.actions.open(name));
      if (name === seen?.scene.name) item.setAttribute("aria-current", "true");
      return item;
    });
    const onPage = this.context.root.dataset.home === "page";
    const files = [
      this.#item("Open a file…", () => this.open(), onPage ? "Ctrl O" : ""),
      this.#item("Save as YAML", () => void this.save(), onPage ? "Ctrl S" : ""),
      ...(onPage ? [this.#item("Copy a link", () => void this.share())] : []),
      this.#item("Picture, SVG", () => void this.picture("svg")),
      this.#item("Picture, PNG", () => void this.picture("png")),
      ...(welcome.value?.reports === true ? [this.#item("Report, HTML", () => void this.report())] : []),
    ];
    this.sheet.open(el("div", { class: "card sheet-card menu-card", role: "menu", "aria-label": "Scenes and files" },
      el("div", { class: "menu-scenes", role: "group", "aria-label": "Scenes" }, ...scenes),
      el("div", { class: "menu-files", role: "group", "aria-label": "Files" }, ...files)), opener);
  }

  open(): void {
    this.#file.click();
  }

  async save(): Promise<void> {
    const text = await this.actions.text();
    if (text !== null) this.#download(new Blob([text], { type: "application/yaml" }), "yaml");
  }

  async share(): Promise<void> {
    const text = await this.actions.text();
    if (text === null) return;
    const link = `${location.origin}${location.pathname}#s=${await toLink(text)}`;
    try {
      await navigator.clipboard.writeText(link);
    } catch {
      this.context.toast("The browser does not let the page copy; the link is in the address bar.");
      history.replaceState(null, "", link);
      return;
    }
    this.context.toast(link.length > LONG_LINK
      ? `Copied: ${link.length} characters. Chat programs cut long links; a file is safer.` : "The link is copied: it holds the scenario, not the key.");
  }

  async picture(kind: "svg" | "png"): Promise<void> {
    const text = svgOf(this.actions.plan());
    if (kind === "svg") this.#download(new Blob([text], { type: "image/svg+xml" }), "svg");
    else this.#download(await pngOf(text), "png");
  }

  async report(): Promise<void> {
    const seen = this.context.store.seen.value;
    const text = await this.actions.text();
    if (seen === null || text === null) return;
    const reply = await this.context.talk.request({ kind: "report", doc: seen.doc, speech: seen.scene.speech, text, format: "html" });
    if (reply.kind === "report") this.#download(new Blob([reply.html], { type: "text/html" }), "html");
    else this.context.toast(reply.kind === "error" ? reply.say : "The report cannot be made of this.");
  }

  async #picked(): Promise<void> {
    const file = this.#file.files?.[0];
    this.#file.value = "";
    if (file !== undefined) this.actions.read(await file.text(), file.name);
  }

  #item(text: string, run: () => void, key = ""): HTMLButtonElement {
    const item = el("button", { type: "button", class: "menu-item", role: "menuitem" }, el("span", {}, text), key === "" ? null : el("kbd", {}, key));
    item.addEventListener("click", () => {
      this.sheet.close();
      run();
    });
    return item;
  }

  #download(blob: Blob, ending: string): void {
    const name = (this.context.store.seen.value?.doc.name ?? "scenario").toLowerCase().replaceAll(/[^a-z0-9]+/g, "-");
    const link = el("a", { href: URL.createObjectURL(blob), download: `${name}.${ending}`, hidden: true });
    this.context.root.append(link);
    link.click();
    link.remove();
    window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }
}
