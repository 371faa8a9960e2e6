// Whether a key press belongs to the page or to a field in which something is typed.

export function isTyping(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  if (!target) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !["checkbox", "radio", "range", "button", "file"].includes(target.type);
}

/** Whether a key is pressed in any control, a slider or a button among them: none of them leaves the page by a key of its own. */
export function isInControl(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  return (
    isTyping(event) ||
    (target instanceof HTMLElement && target.closest("input, select, textarea, button, [role=slider]") !== null)
  );
}

/** What Alt and Shift with a key stand for: letters and digits by their place, since Alt changes what they write. */
export function altShiftKey(
  event: Pick<KeyboardEvent, "altKey" | "shiftKey" | "ctrlKey" | "metaKey" | "code">,
): string | undefined {
  if (!event.altKey || !event.shiftKey || event.ctrlKey || event.metaKey) return undefined;
  return /^(?:Digit|Key)([0-9A-Z])$/.exec(event.code)?.[1];
}

export function isCommand(event: KeyboardEvent, key: string): boolean {
  return (event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === key;
}
