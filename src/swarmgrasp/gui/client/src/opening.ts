/* Opening scenes, from names, files and links, and keeping what was changed in them. */

import { Autosave } from "./autosave";
import type { Context } from "./context";
import type { Incoming, Scene } from "./messages";
import type { Draft } from "./state";

const REST = 300;

export class Opening {
  readonly #saved: Autosave;
  #timer = 0;
  #warned = false;
  #begun = false;

  constructor(readonly context: Context, storage: Storage | null) {
    this.#saved = new Autosave(storage);
    context.store.seen.listen((seen) => {
      clearTimeout(this.#timer);
      if (seen !== null && !seen.moving) this.#timer = window.setTimeout(() => this.#keep(), REST);
    });
    if (storage !== null) window.addEventListener("pagehide", () => this.#keep());
  }

  /** Opens what the link holds, else the scene of that name; once, however often the line falls meanwhile. */
  async first(opens: string, linked: () => Promise<string | null>): Promise<void> {
    if (this.#begun) return;
    this.#begun = true;
    const text = await linked().catch(() => {
      this.context.toast("The link's scenario cannot be read; this is the usual scene.");
      return null;
    });
    this.#begun = (text !== null && (await this.read(text, "link"))) || (await this.open(opens));
  }

  /** Opens a scene; tells whether there is one of that name. */
  async open(name: string): Promise<boolean> {
    this.#keep();
    return this.#opened(await this.context.talk.request({ kind: "open", name }));
  }

  /** Reads a scenario as a scene of its own; tells whether it is one. */
  async read(text: string, name: string): Promise<boolean> {
    this.#keep();
    return this.#opened(await this.context.talk.request({ kind: "text", text, name }));
  }

  #opened(reply: Incoming): boolean {
    const { toast } = this.context;
    if (reply.kind === "scene") void this.#begin(reply);
    else if (reply.kind === "error") toast(reply.say);
    else if (reply.kind === "faults") {
      const [first] = reply.faults;
      const rest = reply.faults.length > 1 ? ` and ${reply.faults.length - 1} more` : "";
      toast(`Not a scenario: ${first?.line == null ? "" : `line ${first.line}: `}${first?.sentence ?? ""}${rest}`);
    }
    return reply.kind === "scene";
  }

  async #begin(scene: Scene): Promise<void> {
    const { store, talk, toast } = this.context;
    const saved = this.#saved.kept(scene.name, scene.text);
    let draft: Draft | undefined;
    if (saved !== null) {
      const again = saved.text === scene.text ? scene
        : await talk.request({ kind: "text", text: saved.text, name: scene.name });
      if (again.kind === "scene") draft = { scene: again, doc: saved.doc };
    }
    store.open(scene, draft);
    if (scene.warnings.length > 0) toast(scene.warnings[0]!.sentence);
    if (draft === undefined) return;
    toast("Your changes are back.", {
      word: "Start over",
      run: () => {
        this.#saved.forget(scene.name, true);
        store.startOver();
      },
    });
  }

  #keep(): void {
    clearTimeout(this.#timer);
    const { store, toast } = this.context;
    const { draft, origin } = store;
    if (draft === null || origin === null) return;
    if (draft.doc === origin.doc) this.#saved.forget(origin.name);
    else if (!this.#saved.keep(origin.name, { of: origin.text, text: draft.scene.text, doc: draft.doc }) && !this.#warned) {
      this.#warned = true;
      toast("The browser has no room to keep these changes; save them as a file.");
    }
  }
}
