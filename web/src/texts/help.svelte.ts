// Help for the entries of jobs. The schema says it in English; German is loaded where it is chosen, and what it lacks stays English.

import type { Help } from "../lib/schema";
import { i18n } from "./i18n.svelte";

/** German texts by the key of the description in the schema. */
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

  of(help: Help | undefined): string {
    if (!help) return "";
    return (i18n.lang === "de" && this.#german[help.key]) || help.english;
  }
}

export const help = new HelpOfEntries();
