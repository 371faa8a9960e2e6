// What a printed page needs from scripts: pictures of the size of the screen made to fit, and charts that were not in view yet.

/** The width of a sheet between its margins, in CSS pixels. */
const SHEET_WIDTH = 690;

/** Keeps a picture that is drawn in pixels of the screen as it is, and makes it smaller on paper: class `on-sheet`. */
export function fitToSheet(element: HTMLElement): () => void {
  const measure = (): void => {
    element.style.setProperty("--sheet-zoom", String(Math.min(1, SHEET_WIDTH / Math.max(1, element.clientWidth))));
    element.style.setProperty("--sheet-height", `${element.clientHeight}px`);
  };
  addEventListener("beforeprint", measure);
  return () => removeEventListener("beforeprint", measure);
}

const missing = new Set<() => Promise<void>>();

/** Notes something that is loaded when it comes into view; the answer takes it off again. */
export function loadForPaper(load: () => Promise<void>): () => void {
  missing.add(load);
  return () => missing.delete(load);
}

/** Prints the page when everything on it is there. */
export async function printPage(): Promise<void> {
  await Promise.all([...missing].map((load) => load()));
  // What was loaded stands in the page from the next task on.
  setTimeout(() => print());
}
