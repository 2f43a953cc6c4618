/* The page: the key from its link, the socket beside it, the widget in its body. */

import { mount } from "./app";
import { fromLink } from "./share";
import { SocketWire } from "./wire";

const KEY = "swarmgrasp key";

/** The parts of the fragment: `k`, the key, and `s`, a scenario. */
const parts = new URLSearchParams(location.hash.slice(1));
const given = parts.get("k");
const linked = parts.get("s");
if (given !== null) localStorage.setItem(KEY, given);
// The key leaves the address bar, so that no copied link holds it.
if (given !== null || linked !== null) history.replaceState(null, "", location.pathname);

const root = document.getElementById("studio")!;
root.dataset.home = "page";
const scheme = location.protocol === "https:" ? "wss:" : "ws:";
mount(root, new SocketWire(`${scheme}//${location.host}/ws`), {
  storage: localStorage,
  key: () => localStorage.getItem(KEY) ?? "",
  linked: async () => (linked === null ? null : fromLink(linked)),
});
