import {setText} from '../shared/elements.js';
import {updateLinkList} from '../shared/link-list.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import {robotEntry, taskEntry} from './entries.js';

const whole = new Intl.NumberFormat(locale);
const $ = (selector) => document.querySelector(selector);

/**
 * Fills the lists of robots and tasks beside the live map.
 *
 * @param isShown whether the filter lets a robot through
 */
export function updateLiveLists(state, isShown) {
  updateLinkList($('#robots'), state.robots.filter(isShown).map(robotEntry));
  $('#no-robots').hidden = state.robots.length > 0;
  const open = state.openTasks;
  updateLinkList($('#tasks'), open.map(taskEntry));
  $('#no-tasks').hidden = open.length > 0;
  const more = state.queued - open.filter((task) => task.state === 'QUEUED').length;
  setText($('#more-tasks'), text('map.tasks.more', whole.format(more)));
  $('#more-tasks').hidden = more <= 0;
}
