/** The page's language; digits are Western in each, as the server writes them. */
export const locale = `${document.documentElement.lang}-u-nu-latn`;

const ARABIC_DIGITS = /[\u0660-\u0669\u06f0-\u06f9]/g;
/** What can be nothing but a decimal comma: three digits behind one may be thousands. */
const DECIMAL_COMMA = /^([+-]?\d+),(\d{1,2})$/;
const MARKS_OF_DIRECTION = /[\u200e\u200f\u061c]/g;

/** A distance for people: below 10 m with one digit after the point. */
export function roundedMetres(metres) {
  const digits = metres < 10 ? 1 : 0;
  return new Intl.NumberFormat(
    locale, {minimumFractionDigits: digits, maximumFractionDigits: digits}).format(metres);
}

/** The number in a form's field, typed as the server understands it; undefined if it is none. */
export function numberIn({value}) {
  const latin = value
    .replace(MARKS_OF_DIRECTION, '')
    .replace(ARABIC_DIGITS, (digit) => digit.charCodeAt(0) & 0xf)
    .replace('\u066b', '.')
    .trim()
    .replace(DECIMAL_COMMA, '$1.$2');
  return latin === '' || !Number.isFinite(Number(latin)) ? undefined : Number(latin);
}
