import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const time = new Intl.DateTimeFormat(locale, {timeStyle: 'short'});
const moment = new Intl.DateTimeFormat(locale, {dateStyle: 'short', timeStyle: 'short'});
const percent = new Intl.NumberFormat(locale, {style: 'percent'});

/** The fault of a robot that refused a connection, or undefined. */
export function refusalOf({errors}) {
  return errors.find(({code}) => code === 'REFUSED');
}

export function robotEntry(robot) {
  return {
    key: `robot ${robot.name}`,
    href: `robots/${encodeURIComponent(robot.name)}`,
    state: robot.state,
    letter: text(`robot.letter.${robot.state}`),
    title: robot.name,
    side: robot.battery === null ? '' : percent.format(robot.battery),
    sentence: robot.alert ?? robot.doing,
    fault: robot.alert ? undefined : (refusalOf(robot) ?? robot.errors[0])?.text,
  };
}

export function taskEntry(task) {
  return {
    key: `task ${task.id}`,
    href: `tasks/${task.id}`,
    state: task.state,
    letter: String(task.id),
    title: task.name,
    side: text(`task.state.${task.kind === 'DRIVE' && task.state === 'TO_OBJECT' ? 'drive' : task.state}`),
    sentence: withExpected(task, task.needs?.question ?? (task.blocked ? task.waitingFor : task.late) ?? task.waitingFor ?? task.robots.join(text('common.comma'))),
  };
}

/** With when it will be delivered, where that can be said. */
function withExpected({expected}, sentence) {
  return expected?.delivery ? text('map.expected', sentence, timeText(new Date(expected.delivery))) : sentence;
}

/** With its day where that is not today. */
function timeText(at) {
  return (at.toDateString() === new Date().toDateString() ? time : moment).format(at);
}

export function standstillEntry({robots: names, since, text: sentence}) {
  return alertEntry({
    key: `standstill ${since} ${names}`,
    href: `robots/${encodeURIComponent(names[0])}`,
    title: text('map.standstill'),
    sentence,
  });
}

export function chargerEntry({name, since, text: sentence}) {
  return alertEntry({
    key: `charger ${since} ${name}`,
    href: 'history?kind=robot.charger-fails',
    title: text('map.charger'),
    sentence,
  });
}

export function chargerShortageEntry({floor, chargerShortage}) {
  return alertEntry({
    key: `chargers of ${floor}`,
    href: 'history?kind=robot.waits-for-charger',
    title: text('map.chargers'),
    sentence: chargerShortage.text,
  });
}

export function leftLoadEntry({task, name, text: sentence}) {
  return {
    key: `load ${task}`,
    href: `tasks/${task}`,
    state: 'CANCELLED',
    letter: String(task),
    title: name,
    side: text('map.leftLoad'),
    sentence,
  };
}

function alertEntry(entry) {
  return {state: 'ERROR', letter: '!', side: '', ...entry};
}
