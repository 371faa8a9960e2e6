// Reads the SVG of a chart without letting anything in it run: no scripts, no foreign content, no handlers, no links outwards.

const FORBIDDEN = "script, foreignObject, iframe, object, embed, animate, set, use, image, style";

export function safeSvg(text: string): SVGElement | undefined {
  const document_ = new DOMParser().parseFromString(text, "image/svg+xml");
  const root = document_.documentElement;
  if (root.localName !== "svg" || document_.querySelector("parsererror")) return undefined;
  root.querySelectorAll(FORBIDDEN).forEach((element) => element.remove());
  for (const element of [root, ...root.querySelectorAll("*")]) {
    for (const { name } of [...element.attributes]) {
      if (/^on/i.test(name) || name === "style" || name.endsWith("href")) element.removeAttribute(name);
    }
  }
  return document.importNode(root, true) as unknown as SVGElement;
}
