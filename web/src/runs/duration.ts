// How long a run took, from being handed in to its end.

import { formatSeconds } from "../lib/number";

interface Times {
  created: string;
  ended?: string | null;
}

/** As text; undefined where the run has not ended, or its times make no sense. Times may have fractions of seconds or none. */
export function tookText({ created, ended }: Times, lang: string): string | undefined {
  if (!ended) return undefined;
  const seconds = (Date.parse(ended) - Date.parse(created)) / 1000;
  if (!(seconds >= 0)) return undefined;
  const areWhole = ![created, ended].some((time) => /\.\d/.test(time));
  return areWhole && seconds < 1 ? "<\u202f1\u202fs" : formatSeconds(seconds, lang);
}
