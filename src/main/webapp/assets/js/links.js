import {element, showEntries, write} from './entries.js';
import {address} from './server.js';

/**
 * Makes a list show these things with links to them.
 *
 * @param entries each with key, href, state, letter, title, side, and what was said or a text of the
 *     page's own
 */
export function showLinks(list, entries) {
  showEntries(list, entries, ({key}) => key, ({href}) => makeEntry(href), fillEntry);
}

function makeEntry(href) {
  const link = element(
    'a',
    '',
    element('span', 'letter'),
    element('strong', '', element('bdi')),
    element('span', 'side'),
    element('span', 'what', element('bdi')));
  link.href = address(href);
  return element('li', '', link);
}

/** What the fleet says is English; where it says nothing there is a text in the page's language. */
function fillEntry(item, {state, letter, title, side, said, what}) {
  const sign = item.querySelector('.letter');
  sign.dataset.state = state;
  write(sign, letter);
  write(item.querySelector('strong bdi'), title);
  write(item.querySelector('.side'), side);
  const words = item.querySelector('.what bdi');
  words.lang = said ? 'en' : document.documentElement.lang;
  words.dir = said ? 'ltr' : 'auto';
  write(words, said ?? what ?? '');
}
