// Where in the job the user is: the table that the form shows, and wishes to jump to a field or a place in the text.

import type { Finding } from "../api/types";
import { parsePath, pathText, type Path } from "../lib/path";
import { rangeOfFinding } from "./text";

class Place {
  table = $state("job");
  /** The field that shall get the focus. */
  field = $state<string>();
  /** The range of the text that shall be shown. */
  range = $state.raw<{ from: number; to: number }>();

  goToFinding(finding: Finding, text: string): void {
    if (finding.field) this.goToField(parsePath(finding.field));
    if (finding.line || typeof finding.start === "number") this.range = rangeOfFinding(text, finding);
  }

  goToField(path: Path): void {
    this.table = String(path[0] ?? this.table);
    this.field = pathText(path);
  }
}

export const place = new Place();
