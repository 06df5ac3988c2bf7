import {locale} from './locale.js';

/** Shows every time element in the reader's own time zone and manner. */
const format = new Intl.DateTimeFormat(locale, {
  dateStyle: 'medium',
  timeStyle: 'short',
});

/** Of reports, which come several times a second. */
const exact = new Intl.DateTimeFormat(locale, {dateStyle: 'medium', timeStyle: 'medium'});

export function showTimes(within = document) {
  for (const time of within.querySelectorAll('time[datetime]')) {
    showTime(time);
  }
}

export function showTime(time) {
  const text = ('lastSeen' in time.dataset ? exact : format).format(new Date(time.dateTime));
  if (time.textContent !== text) {
    time.textContent = text;
  }
  time.title = time.dateTime;
}

showTimes();
