/** The state of the page in its address, so that a link restores it. */

/** @typedef {import("./present.js").Present} Present */

/** What the address holds beside the touchdown, by short names. @typedef {Record<string, string>} Extra */

const PREFIX = "v.";

/** @param {Present} present @param {Extra} extra */
export function toAddress(present, extra) {
  const parts = new URLSearchParams();
  parts.set("source", present.source);
  parts.set("units", present.units);
  for (const [name, value] of Object.entries(extra)) if (value !== "") parts.set(name, value);
  for (const [name, value] of Object.entries(present.values)) parts.set(PREFIX + name, String(value));
  return `#${parts.toString().replaceAll("%5B", "[").replaceAll("%5D", "]")}`;
}

/**
 * Takes a touchdown from an address; words stay words and numbers become numbers.
 * @param {string} hash
 * @returns {{ source: string | null, units: string | null, values: Record<string, number | string>, extra: Extra }}
 */
export function fromAddress(hash) {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  /** @type {Record<string, number | string>} */
  const values = {};
  /** @type {Extra} */
  const extra = {};
  for (const [name, text] of parts) {
    if (name.startsWith(PREFIX)) {
      const number = Number(text);
      values[name.slice(PREFIX.length)] = text !== "" && Number.isFinite(number) ? number : text;
    } else if (name !== "source" && name !== "units") {
      extra[name] = text;
    }
  }
  return { source: parts.get("source"), units: parts.get("units"), values, extra };
}
