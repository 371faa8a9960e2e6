// Symbols of characteristics as a sheet has them: the store writes fHa, a sheet fHα.

const GREEK: Record<string, string> = { a: "α", b: "β" };

/** The symbol of a characteristic of the profile (a) or the helix (b); other names stay as they are. */
export function symbolOf(name: string): string {
  const [, stem, letter] = /^(fH|ff|F|C)([ab])$/.exec(name) ?? [];
  return stem && letter ? stem + GREEK[letter] : name;
}
