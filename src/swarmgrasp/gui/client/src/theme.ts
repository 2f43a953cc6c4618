/* Dark or light: as the system has it, until somebody chooses. */

const KEPT = "swarmgrasp theme";

/** Gives back the choice that was made, and returns what changes it. */
export function themed(root: HTMLElement, storage: Storage | null): () => void {
  const kept = storage?.getItem(KEPT);
  if (kept === "dark" || kept === "light") root.dataset.theme = kept;
  return () => {
    const dark = root.dataset.theme === undefined
      ? matchMedia("(prefers-color-scheme: dark)").matches : root.dataset.theme === "dark";
    root.dataset.theme = dark ? "light" : "dark";
    storage?.setItem(KEPT, root.dataset.theme);
  };
}
