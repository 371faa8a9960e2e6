// The page that the address names: `#/runs/12/flank` is the view `runs` with the parts `12` and `flank`.

class Router {
  parts = $state<string[]>(read());
  /** What stands behind a question mark in the hash. */
  query = $state(readQuery());
  view = $derived(this.parts[0] ?? "job");

  constructor() {
    addEventListener("hashchange", () => {
      this.parts = read();
      this.query = readQuery();
    });
  }

  go(address: string): void {
    location.hash = address;
  }

  /** Changes the address without a new entry in the history of the browser. */
  replace(address: string): void {
    history.replaceState(null, "", address);
    this.parts = read();
    this.query = readQuery();
  }
}

function read(): string[] {
  const path = location.hash.replace(/^#\/?/, "").split("?")[0] ?? "";
  const parts = path.split("/").filter((part) => part !== "");
  return parts.map(decodeURIComponentSafely);
}

function readQuery(): URLSearchParams {
  return new URLSearchParams(location.hash.split("?")[1] ?? "");
}

function decodeURIComponentSafely(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

export const router = new Router();
