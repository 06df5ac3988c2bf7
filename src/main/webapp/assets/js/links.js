import {element, showEntries, write} from './entries.js';
import {address} from './server.js';

/**
 * Makes a list show these things with links to them.
 *
 * @param entries each with key, href, state, letter, title, side, what there is to say, and a robot's
 *     own words for a fault, which are English and go before it
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

function fillEntry(item, {state, letter, title, side, what, fault}) {
  const sign = item.querySelector('.letter');
  sign.dataset.state = state;
  write(sign, letter);
  write(item.querySelector('strong bdi'), title);
  write(item.querySelector('.side'), side);
  const words = item.querySelector('.what bdi');
  words.lang = fault ? 'en' : document.documentElement.lang;
  words.dir = fault ? 'ltr' : document.dir;
  write(words, fault ?? what ?? '');
}
