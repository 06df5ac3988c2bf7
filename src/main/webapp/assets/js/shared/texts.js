/** The texts that the page brought for its scripts, in the user's language. */
const texts = new Map();
for (const data of document.querySelector('#texts')?.content.querySelectorAll('data') ?? []) {
  texts.set(data.value, data.textContent);
}

/** The text of that key, with {0}, {1}... replaced by the values. */
export function text(key, ...values) {
  return (texts.get(key) ?? key).replace(/\{(\d)\}/g, (_, i) => values[i] ?? '');
}
