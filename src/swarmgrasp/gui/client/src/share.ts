/* Links that carry a scenario: its text, deflated, in the fragment, which is sent to no server. */

/** Longest text that a link may hold when it is inflated. */
export const LONGEST = 1 << 20;

async function through(bytes: Uint8Array<ArrayBuffer>, way: CompressionStream | DecompressionStream): Promise<Uint8Array<ArrayBuffer>> {
  const writer = way.writable.getWriter();
  const wrote = writer.write(bytes).then(() => writer.close());
  wrote.catch(() => undefined);
  const found: Uint8Array[] = [];
  let length = 0;
  const reader = way.readable.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > LONGEST) {
      await reader.cancel();
      throw new Error("The link holds more than 1 MB.");
    }
    found.push(value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const piece of found) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

/** A text as base64url of its deflated bytes. */
export async function toLink(text: string): Promise<string> {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let words = "";
  for (const byte of bytes) words += String.fromCharCode(byte);
  return btoa(words).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The text that a link holds. */
export async function fromLink(link: string): Promise<string> {
  const words = atob(link.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(words, (letter) => letter.charCodeAt(0));
  return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw")));
}
