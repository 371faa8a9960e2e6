// The unit that a key of a job or result carries at its end, and its name without it.

const UNITS: [RegExp, string][] = [
  [/_um_per_feed_um$/, "µm/µm"],
  [/_um_per_workpiece_pulse$/, "µm"],
  [/_um_per_rad$/, "µm/rad"],
  [/_um_per_m$/, "µm/m"],
  [/_mm_per_rad$/, "mm/rad"],
  [/_ppm$/, "ppm"],
  [/_mm_per_min$/, "mm/min"],
  [/_mm_per_s2$/, "mm/s²"],
  [/_mm_per_s$/, "mm/s"],
  [/_m_per_s$/, "m/s"],
  [/_deg_per_s2$/, "°/s²"],
  [/_deg_per_s$/, "°/s"],
  [/_um_per_kelvin$/, "µm/K"],
  [/_kelvin$/, "K"],
  [/_arcsec$/, "″"],
  [/_urad$/, "µrad"],
  [/_rpm$/, "1/min"],
  [/_deg$/, "°"],
  [/_rad$/, "rad"],
  [/_um$/, "µm"],
  [/_mm2$/, "mm²"],
  [/_mm$/, "mm"],
  [/_hz$/, "Hz"],
  [/_ms$/, "ms"],
  [/_us$/, "µs"],
  [/_s$/, "s"],
  [/_percent$/, "%"],
];

/** Keys that end like a unit and are none. */
const LENGTH_WORDS =
  /(^|_)(diameter|radius|width|module|length|height|thickness|distance|clearance|allowance|overrun|stroke|overlap|depth|gap|offset|land|travel|start|end)(_|$)/;
const COUNTS =
  /(^|_)(teeth|threads|points|count|intervals|steps|areas|number|rounds|profiles|helices|seed|share|ratio|shift_ratio|per_revolution)(_|$)/;

/** The unit of a key; plain lengths are mm where the name tells that it is a length. */
export function unitOfKey(key: string, numeric = true): string {
  for (const [ending, unit] of UNITS) if (ending.test(key)) return unit;
  if (!numeric) return "";
  if (key === "feed_per_revolution") return "mm";
  if (COUNTS.test(key)) return "";
  return LENGTH_WORDS.test(key) || key === "module" ? "mm" : "";
}

/** A key without its unit. */
export function keyWithoutUnit(key: string): string {
  for (const [ending] of UNITS) if (ending.test(key)) return key.replace(ending, "");
  return key;
}

/** A key as words: `tip_diameter` becomes `Tip diameter`; symbols, which are one letter or have capitals inside, stay as they are. */
export function keyAsWords(key: string): string {
  const words = keyWithoutUnit(key).replaceAll("_", " ").replaceAll("-", " ").trim();
  if (words === "") return key;
  const isSymbol = /^([a-z]|[a-z]+[A-Z]\w*)( |$)/.test(words);
  return isSymbol ? words : words.charAt(0).toUpperCase() + words.slice(1);
}

const SIGNS: Record<string, string> = { deg: "°", um: "µm", "1": "", "deg/s": "°/s", "um/K": "µm/K" };

/** A unit of the server as it is shown: `um` as µm, `deg` as °. */
export function shownUnit(unit: string): string {
  return SIGNS[unit] ?? unit;
}
