/** Numbers and words as the pictures of results have them. */

/**
 * A number with at most so many significant digits, with a true minus sign.
 * @param {number | null | undefined} value
 * @param {number} [digits]
 */
export function label(value, digits = 6) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/**
 * A number with so many digits after the point.
 * @param {number} value
 * @param {number} decimals
 */
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}

/** @param {string} unit */
export const inUnit = (unit) => (unit ? ` ${unit}` : "");

/** @param {string} title @param {string} unit */
export const withUnit = (title, unit) => (unit && !title.endsWith(`, ${unit}`) ? `${title}, ${unit}` : title);

/** A title with V_H and V_V as elements with a subscript. @param {string} text */
export function subscripted(text) {
  const fragment = document.createDocumentFragment();
  for (const [index, part] of text.split(/\bV_([HV])\b/).entries()) {
    if (index % 2 === 0) {
      fragment.append(part);
    } else {
      const sub = document.createElement("sub");
      sub.textContent = part;
      fragment.append("V", sub);
    }
  }
  return fragment;
}

/** The least of 1, 2 and 5 times a power of ten that is not below a number. @param {number} rough */
export function roundStep(rough) {
  if (!(rough > 0) || !Number.isFinite(rough)) return 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough * 0.999) ?? 10 * power;
}

/** Round values between two ends, about so many. @param {number} from @param {number} to @param {number} count */
export function roundValues(from, to, count) {
  const step = roundStep((to - from) / Math.max(count, 1));
  const values = [];
  for (let index = Math.ceil(from / step - 1e-9); index * step <= to + 1e-9 * step && values.length < 60; index += 1) {
    values.push(Number((index * step).toPrecision(12)));
  }
  return values;
}
