// Small settings of the pages that outlive a reload. A browser that keeps nothing is served all the same.

const PREFIX = "flankwright.";

export function readSetting(name: string): string | undefined {
  try {
    return localStorage.getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

export function writeSetting(name: string, value: string): void {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // Storage is full or forbidden: the setting holds until the page is left.
  }
}
