import {locale} from './locale.js';

/** Shows every time element in the reader's own time zone and manner. */
const format = new Intl.DateTimeFormat(locale, {
  dateStyle: 'medium',
  timeStyle: 'short',
});

export function showTimes(within = document) {
  for (const time of within.querySelectorAll('time[datetime]')) {
    time.textContent = format.format(new Date(time.dateTime));
    time.title = time.dateTime;
  }
}

showTimes();
