// Help for the entries of jobs. The schema says it in English; German is loaded where it is chosen, and what it lacks stays English.

import { i18n } from "./i18n.svelte";

/** The German text of an English one. */
export type HelpTexts = Readonly<Record<string, string>>;

export class HelpOfEntries {
  #german = $state.raw<HelpTexts>({});
  #isLoaded = false;

  async load(load: () => Promise<{ default: HelpTexts }> = () => import("./help-de.json")): Promise<void> {
    if (i18n.lang !== "de" || this.#isLoaded) return;
    try {
      this.#german = (await load()).default;
      this.#isLoaded = true;
    } catch {
      // The server is gone or has other pages by now, which the form says elsewhere: help stays English.
    }
  }

  of(english: string): string {
    return (i18n.lang === "de" && this.#german[english]) || english;
  }
}

export const help = new HelpOfEntries();
