import {createElement, setText, updateList} from './elements.js';
import {address} from './server.js';

const WRITTEN = ['state', 'letter', 'title', 'side', 'sentence', 'fault'];
const shown = new WeakMap(); // by the element, the entry that is written into it

/**
 * Fills a list with entries that are links.
 *
 * @param entries each with key, href, state, letter, title, side, sentence, and the fault that a
 *     robot reports in English, which is shown instead of the sentence
 */
export function updateLinkList(list, entries) {
  updateList(list, entries, ({key}) => key, ({href}) => createEntry(href), fillEntry);
}

function createEntry(href) {
  const link = createElement(
    'a',
    '',
    createElement('span', 'letter'),
    createElement('strong', '', createElement('bdi')),
    createElement('span', 'side'),
    createElement('span', 'sentence', createElement('bdi')));
  link.href = address(href);
  return createElement('li', '', link);
}

function fillEntry(item, entry) {
  const before = shown.get(item);
  if (before && WRITTEN.every((part) => before[part] === entry[part])) {
    return; // hundreds of robots report ten times a second, and few of them anything that is written here
  }
  shown.set(item, entry);
  const {state, letter, title, side, sentence, fault} = entry;
  const sign = item.querySelector('.letter');
  sign.dataset.state = state;
  setText(sign, letter);
  setText(item.querySelector('strong bdi'), title);
  setText(item.querySelector('.side'), side);
  const words = item.querySelector('.sentence bdi');
  words.lang = fault ? 'en' : document.documentElement.lang;
  words.dir = fault ? 'ltr' : document.dir;
  setText(words, fault ?? sentence ?? '');
}
