// Numbers as an engineer reads them: the decimals that matter, a unit behind a narrow space, the decimal sign of the language.

/** What a quantity without a value shows. */
export const NO_VALUE = "–";
const NARROW_SPACE = "\u202f";

/** A number with the given count of significant digits, without trailing noise; `unit` follows where there is one. */
export function formatNumber(value: number | null | undefined, lang: string, digits = 4, unit = ""): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NO_VALUE;
  const size = Math.abs(value);
  const tail = tailOf(unit);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) {
    const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 2)).split("e") as [string, string];
    const local = Number(mantissa).toLocaleString(lang, { maximumFractionDigits: digits });
    return `${local}e${Number(exponent)}${tail}`;
  }
  const options: Intl.NumberFormatOptions = { maximumSignificantDigits: digits, useGrouping: size >= 1e4 };
  return (Object.is(value, -0) ? 0 : value).toLocaleString(lang, options) + tail;
}

/** A number with a fixed count of decimals, for columns that shall align. */
export function formatFixed(value: number | null | undefined, lang: string, decimals: number, unit = ""): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NO_VALUE;
  const rounded = Number(value.toFixed(decimals));
  const text = (Object.is(rounded, -0) ? 0 : rounded).toLocaleString(lang, {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
    useGrouping: Math.abs(value) >= 1e4,
  });
  return text + tailOf(unit);
}

/** A unit stands behind a narrow space, the sign of degrees at once. */
function tailOf(unit: string): string {
  return unit === "" || unit === "°" ? unit : NARROW_SPACE + unit;
}

/** A number as typed, with a point or a comma as decimal sign; undefined where it is none. */
export function parseNumber(text: string): number | undefined {
  const plain = text
    .trim()
    .replace(/[\s\u202f\u00a0_]/g, "")
    .replace(",", ".")
    .replace("−", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return undefined;
  const value = Number(plain);
  return Number.isFinite(value) ? value : undefined;
}

/** The value one step up or down, the step being one in the last digit that is written. */
export function stepNumber(text: string, steps: number): string {
  const value = parseNumber(text);
  if (value === undefined) return text;
  const plain = text.trim().replace(",", ".");
  if (/e/i.test(plain)) return String(value + steps * 10 ** (Math.floor(Math.log10(Math.abs(value) || 1)) - 1));
  const decimals = plain.includes(".") ? plain.length - plain.indexOf(".") - 1 : 0;
  return (value + steps * 10 ** -decimals).toFixed(decimals);
}

/** Bytes as B, kB or MB. */
export function formatBytes(bytes: number, lang: string): string {
  if (bytes < 1000) return `${bytes}${NARROW_SPACE}B`;
  if (bytes < 1e6) return formatNumber(bytes / 1e3, lang, 3, "kB");
  return formatNumber(bytes / 1e6, lang, 3, "MB");
}

/** Seconds as ms, s, min or h. */
export function formatSeconds(seconds: number, lang: string): string {
  if (seconds < 1) return formatNumber(seconds * 1000, lang, 3, "ms");
  if (seconds < 99.95) return formatNumber(seconds, lang, 3, "s");
  const inHours = seconds >= 5999.5;
  const whole = Math.round(inHours ? seconds / 60 : seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}${NARROW_SPACE}${inHours ? "h" : "min"}`;
}
