/**
 * Fills a list with these entries in this order, changing only the elements that differ, so that
 * focus and screen readers stay where they are.
 *
 * @param keyOf answers what tells an entry from the others
 * @param create makes the element of an entry
 * @param fill writes an entry into its element
 */
export function updateList(list, entries, keyOf, create, fill) {
  const present = new Map([...list.children].map((element) => [element.dataset.key, element]));
  entries.forEach((entry, index) => {
    const key = String(keyOf(entry));
    let element = present.get(key);
    if (!element) {
      element = create(entry);
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

/** Sets the text of an element only where it differs. */
export function setText(element, content) {
  if (element.textContent !== content) {
    element.textContent = content;
  }
}

/** A new element with a class and children. */
export function createElement(name, className = '', ...children) {
  const created = document.createElement(name);
  created.className = className;
  created.append(...children);
  return created;
}
