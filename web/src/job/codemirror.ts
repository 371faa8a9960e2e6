// The text editor of jobs: line numbers, TOML colours, findings at their places. Undo belongs to the job, not to the editor.

import { defaultKeymap } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, nextDiagnostic, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, type Extension } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Finding } from "../api/types";
import { changeBetween, rangeOfFinding } from "./text";

export interface TextEditor {
  setText(text: string): void;
  setFindings(findings: Finding[]): void;
  goTo(from: number, to: number): void;
  destroy(): void;
}

export interface TextEditorOptions {
  text: string;
  label: string;
  onchange: (text: string) => void;
  onundo: () => void;
  onredo: () => void;
  readOnly?: boolean;
}

const External = Annotation.define<boolean>();

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--good)" },
  { tag: [tags.number, tags.atom, tags.bool], color: "var(--rust)" },
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--accent)" },
]);

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13px", color: "var(--ink)", backgroundColor: "var(--surface)" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "var(--raised)", color: "var(--muted)", borderRight: "1px solid var(--line)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--accent) 7%, transparent)" },
  ".cm-activeLineGutter": { backgroundColor: "var(--sunken)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--accent-soft)" },
  ".cm-tooltip": {
    backgroundColor: "var(--surface)",
    border: "1px solid var(--line-strong)",
    color: "var(--ink)",
    maxWidth: "460px",
  },
  ".cm-diagnostic": { padding: "6px 10px", whiteSpace: "pre-wrap" },
  ".cm-panels": { backgroundColor: "var(--raised)", color: "var(--ink)", borderColor: "var(--line)" },
});

export function openTextEditor(parent: HTMLElement, options: TextEditorOptions): TextEditor {
  const nonce = document.querySelector<HTMLMetaElement>('meta[name="csp-nonce"]')?.content ?? "";
  const own = (run: () => void) => () => (run(), true);
  const extensions: Extension[] = [
    EditorView.cspNonce.of(nonce),
    EditorView.contentAttributes.of({ "aria-label": options.label, spellcheck: "false" }),
    EditorState.readOnly.of(options.readOnly ?? false),
    lineNumbers(),
    lintGutter(),
    drawSelection(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSelectionMatches(),
    bracketMatching(),
    search({ top: true }),
    StreamLanguage.define(toml),
    syntaxHighlighting(colours),
    look,
    keymap.of([
      { key: "Mod-z", run: own(options.onundo) },
      { key: "Mod-y", run: own(options.onredo) },
      { key: "Mod-Shift-z", run: own(options.onredo) },
      { key: "F8", run: nextDiagnostic },
      { key: "Escape", run: (view) => (view.contentDOM.blur(), true) },
      ...searchKeymap,
      ...defaultKeymap.filter((binding) => binding.key !== "Mod-Enter"),
    ]),
    // Files that are dropped are opened by the page, not written into the text.
    EditorView.domEventHandlers({ drop: (event) => (event.dataTransfer?.files.length ?? 0) > 0 }),
    EditorView.updateListener.of((update) => {
      const isOwn = update.transactions.some((change) => change.annotation(External));
      if (update.docChanged && !isOwn) options.onchange(update.state.doc.toString());
    }),
  ];
  const view = new EditorView({ parent, state: EditorState.create({ doc: options.text, extensions }) });
  return {
    setText(text) {
      const change = changeBetween(view.state.doc.toString(), text);
      if (change) view.dispatch({ changes: change, annotations: External.of(true) });
    },
    setFindings(findings) {
      const text = view.state.doc.toString();
      view.dispatch(
        setDiagnostics(
          view.state,
          findings.map((finding) => diagnosticOf(text, finding)),
        ),
      );
    },
    goTo(from, to) {
      const most = view.state.doc.length;
      const range = { anchor: Math.min(from, most), head: Math.min(to, most) };
      view.dispatch({ selection: range, effects: EditorView.scrollIntoView(range.anchor, { y: "center" }) });
      view.focus();
    },
    destroy: () => view.destroy(),
  };
}

function diagnosticOf(text: string, finding: Finding): Diagnostic {
  const range = rangeOfFinding(text, finding);
  const lines = [finding.message, finding.allowed ?? "", finding.way_out ?? ""].filter((line) => line !== "");
  return { ...range, severity: "error", message: lines.join("\n") };
}
