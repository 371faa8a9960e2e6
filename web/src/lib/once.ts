// Work that is not begun again while it is under way: a double click asks for one run, not for two.

/** `keyOf` tells what may go on side by side, such as the same work on different runs. */
export function once<A extends unknown[]>(
  work: (...input: A) => Promise<void>,
  keyOf: (...input: A) => string = () => "",
): (...input: A) => Promise<void> {
  const pending = new Map<string, Promise<void>>();
  return (...input) => {
    const key = keyOf(...input);
    const under = pending.get(key) ?? work(...input).finally(() => pending.delete(key));
    pending.set(key, under);
    return under;
  };
}
