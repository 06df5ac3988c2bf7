import {setText} from '../shared/elements.js';
import {updateLinkList} from '../shared/link-list.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';
import {robotEntry, taskEntry} from './entries.js';

const whole = new Intl.NumberFormat(locale);
const $ = (selector) => document.querySelector(selector);

/**
 * Fills the lists of robots and tasks beside the live map: those of the floor.
 *
 * @param floor its name; undefined: those of all floors
 * @param isShown whether the filter lets a robot through
 */
export function updateLiveLists(state, floor, isShown) {
  const isHere = (one) => floor === undefined || one.floor === floor;
  const robots = state.robots.filter(isHere);
  updateLinkList($('#robots'), robots.filter(isShown).map(robotEntry));
  $('#no-robots').hidden = robots.length > 0;
  const open = state.openTasks.filter(isHere);
  updateLinkList($('#tasks'), open.map(taskEntry));
  $('#no-tasks').hidden = open.length > 0;
  const more = state.queued - state.openTasks.filter((task) => task.state === 'QUEUED').length;
  setText($('#more-tasks'), text('map.tasks.more', whole.format(more)));
  $('#more-tasks').hidden = more <= 0;
}
