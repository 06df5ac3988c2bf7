/**
 * Makes a list show these entries in this order, touching only what has changed, so that focus and
 * screen readers stay where they are.
 *
 * @param make makes the element of an entry
 * @param fill writes an entry into its element
 */
export function showEntries(list, entries, keyOf, make, fill) {
  const present = new Map([...list.children].map((element) => [element.dataset.key, element]));
  entries.forEach((entry, index) => {
    const key = String(keyOf(entry));
    let element = present.get(key);
    if (!element) {
      element = make(entry);
      element.dataset.key = key;
    }
    present.delete(key);
    fill(element, entry);
    if (list.children[index] !== element) {
      list.insertBefore(element, list.children[index] ?? null);
    }
  });
  present.forEach((element) => element.remove());
}

/** Writes text only where it differs. */
export function write(element, content) {
  if (element.textContent !== content) {
    element.textContent = content;
  }
}

/** An element with a class and children. */
export function element(name, className = '', ...children) {
  const made = document.createElement(name);
  made.className = className;
  made.append(...children);
  return made;
}
