/* What the build puts into the widget. */

declare module "*.woff2" {
  const bytes: Uint8Array<ArrayBuffer>;
  export default bytes;
}

declare module "styles" {
  const text: string;
  export default text;
}
