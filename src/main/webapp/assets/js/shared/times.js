import {locale} from './locale.js';

/** Shows every time element in the reader's own time zone and manner. */
const format = new Intl.DateTimeFormat(locale, {
  dateStyle: 'medium',
  timeStyle: 'short',
});

/** Of reports, which come several times a second. */
const today = new Intl.DateTimeFormat(locale, {timeStyle: 'medium'});

export function showTimes(within = document) {
  for (const time of within.querySelectorAll('time[datetime]')) {
    showTime(time);
  }
}

export function showTime(time) {
  const at = new Date(time.dateTime);
  const isShort = 'lastSeen' in time.dataset && at.toDateString() === new Date().toDateString();
  const text = (isShort ? today : format).format(at);
  if (time.textContent !== text) {
    time.textContent = text;
  }
  time.title = time.dateTime;
}

showTimes();
