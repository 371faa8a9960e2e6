// The language of the pages: chosen once, kept in the browser, else that of the browser.

import { de } from "./de";
import { en, type Texts } from "./en";
import { KEY_NAMES_DE } from "./keys-de";
import { DERIVED_DE } from "./keys-de-derived";
import { JOB_KEYS_DE } from "./keys-de-jobs";
import { RESULT_KEYS_DE } from "./keys-de-results";
import { WORDS_DE } from "./keys-de-words";
import { KEY_NAMES_EN } from "./keys-en";
import { formatFixed, formatNumber, NO_VALUE } from "../lib/number";
import { keyAsWords } from "../lib/units";
import { readSetting, writeSetting } from "../state/settings";

export type Language = "en" | "de";

const NAMES: Record<Language, Record<string, string>> = {
  en: KEY_NAMES_EN,
  de: { ...RESULT_KEYS_DE, ...DERIVED_DE, ...WORDS_DE, ...JOB_KEYS_DE, ...KEY_NAMES_DE },
};

class I18n {
  lang = $state<Language>(startLanguage());
  t: Texts = $derived(this.lang === "de" ? de : en);

  set(lang: Language): void {
    this.lang = lang;
    document.documentElement.lang = lang;
    writeSetting("language", lang);
  }

  /** A number with its unit. */
  num(value: number | null | undefined, unit = "", digits = 4): string {
    return formatNumber(value, this.lang, digits, unit);
  }

  fixed(value: number | null | undefined, decimals: number, unit = ""): string {
    return formatFixed(value, this.lang, decimals, unit);
  }

  /** A share of one as a percentage. */
  percent(share: number | null | undefined, decimals: number): string {
    return this.fixed(share === null || share === undefined ? undefined : 100 * share, decimals, "%");
  }

  /** The name of a key of a job in words of the field. */
  key(key: string): string {
    return NAMES[this.lang][key] ?? keyAsWords(key);
  }

  /** The name of what the server names in English. */
  named(key: string, english: string): string {
    return (this.lang === "de" ? NAMES.de[key] : undefined) ?? english;
  }

  /** A point in time as date and time of day. */
  time(iso: string | null | undefined): string {
    return this.#shown(iso, { dateStyle: "medium", timeStyle: "short" });
  }

  date(iso: string | null | undefined): string {
    return this.#shown(iso, { dateStyle: "medium" });
  }

  #shown(iso: string | null | undefined, style: Intl.DateTimeFormatOptions): string {
    if (!iso) return NO_VALUE;
    const date = new Date(iso);
    if (Number.isNaN(date.getTime())) return iso;
    return date.toLocaleString(this.lang === "de" ? "de-DE" : "en-GB", style);
  }
}

function startLanguage(): Language {
  const kept = readSetting("language");
  if (kept === "de" || kept === "en") return kept;
  return typeof navigator !== "undefined" && navigator.language.startsWith("de") ? "de" : "en";
}

export const i18n = new I18n();
