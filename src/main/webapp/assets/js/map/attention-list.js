import {updateLinkList} from '../shared/link-list.js';
import {chargerEntry, chargerShortageEntry, leftLoadEntry, refusalOf, robotEntry, standstillEntry, taskEntry} from './entries.js';

/** What needs attention, the most urgent first. */
const URGENCY = ['ERROR', 'question', 'standstill', 'LOST', 'NOT_LOCALISED', 'charger', 'blocked', 'load', 'alert'];
const ALERT_STATES = new Set(['ERROR', 'NOT_LOCALISED', 'LOST']);

/** Fills the list of what needs attention, and hides it where nothing does. */
export function updateAttentionList(section, {floors, tasks, robots}) {
  const entries = [
    ...floors.flatMap(({standstills}) => standstills.map((one) => ranked('standstill', standstillEntry(one)))),
    ...floors.flatMap(({faultyChargers}) => faultyChargers.map((one) => ranked('charger', chargerEntry(one)))),
    ...floors.filter(({chargerShortage}) => chargerShortage).map((floor) => ranked('charger', chargerShortageEntry(floor))),
    ...floors.flatMap(({leftLoads}) => leftLoads.map((one) => ranked('load', leftLoadEntry(one)))),
    ...tasks.filter(({needs, blocked}) => needs || blocked).map((task) => ranked(task.needs ? 'question' : 'blocked', taskEntry(task))),
    ...robots
      .filter(needsAttention)
      .map((robot) => ranked(ALERT_STATES.has(robot.state) ? robot.state : 'alert', robotEntry(robot))),
  ].sort((a, b) => a.rank - b.rank);
  updateLinkList(section.querySelector('ul'), entries);
  section.hidden = entries.length === 0;
}

function needsAttention(robot) {
  return ALERT_STATES.has(robot.state) || robot.alert !== null || refusalOf(robot) !== undefined;
}

function ranked(kind, entry) {
  return {...entry, rank: URGENCY.indexOf(kind)};
}
