import {fetchJson} from '../shared/server.js';
import {locale} from '../shared/locale.js';
import {playSound} from './sound.js';

/** What pages of this browser have told last, so that another page, or the next one, does not tell it again. */
const TOLD = 'toqa.notices.told';
/** Milliseconds between two looks of a page that has no live events. */
const PERIOD = 60_000;
/** Milliseconds, so that not all browsers ask at once. */
const SPREAD = 300;
const MOST = 99;

const bell = document.querySelector('.bell');
const count = bell.querySelector('.count');
const icon = document.querySelector('link[rel="icon"]');
const plainIcon = icon.href;
const plainTitle = document.title;
const plainName = bell.getAttribute('aria-label');
let shown = 0;
let asked = false;
let looking = false;
let outdated = false; // while it looks: something has changed meanwhile

document.addEventListener('toqa-notices', ask);
setInterval(update, PERIOD);
update();

function ask() {
  if (!asked) {
    asked = true;
    setTimeout(() => {
      asked = false;
      update();
    }, SPREAD * Math.random());
  }
}

/** Looks once at a time: an older answer never follows a newer one. */
async function update() {
  if (looking) {
    outdated = true;
    return;
  }
  looking = true;
  do {
    outdated = false;
    try {
      await (navigator.locks ? navigator.locks.request(TOLD, look) : look());
    } catch {
      // the page says by itself that the server does not answer
    }
  } while (outdated);
  looking = false;
}

/** Where there are locks, no two pages of the browser do so at the same moment, and tell the same. */
async function look() {
  const news = await fetchJson('api/v1/notices/news');
  showCount(news.unseen);
  tell(news);
}

function showCount(unseen) {
  if (unseen === shown) {
    return;
  }
  shown = unseen;
  const text = unseen > MOST ? `${MOST}+` : new Intl.NumberFormat(locale).format(unseen);
  count.hidden = unseen === 0;
  count.textContent = text;
  const name = unseen === 0 ? plainName : bell.dataset.unseen.replace('{0}', text);
  bell.setAttribute('aria-label', name);
  bell.title = name;
  document.title = unseen === 0 ? plainTitle : `(${text}) ${plainTitle}`;
  showIcon(unseen);
}

/** The icon of the page's tab, with a red dot while there is something unseen. */
function showIcon(unseen) {
  if (unseen === 0) {
    icon.href = plainIcon;
    return;
  }
  const image = new Image();
  image.addEventListener('load', () => {
    if (shown === 0) {
      return;
    }
    const canvas = Object.assign(document.createElement('canvas'), {width: 64, height: 64});
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0, 64, 64);
    context.beginPath();
    context.arc(46, 18, 18, 0, 2 * Math.PI);
    context.fillStyle = '#d32f2f';
    context.fill();
    context.fillStyle = '#fff';
    context.font = '700 24px sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(shown > 9 ? '9+' : String(shown), 46, 19);
    icon.type = 'image/png';
    icon.href = canvas.toDataURL('image/png');
  });
  image.src = plainIcon;
}

function tell({latest, told}) {
  const last = Number(localStorage.getItem(TOLD) ?? latest);
  if (last !== latest || localStorage.getItem(TOLD) === null) {
    localStorage.setItem(TOLD, String(latest));
  }
  const fresh = told.filter(({id}) => id > last);
  fresh.filter(({browser}) => browser).forEach(showNotification);
  if (fresh.some(({sound}) => sound)) {
    playSound();
  }
}

function showNotification({uid, title, text}) {
  if (!('Notification' in window) || Notification.permission !== 'granted') {
    return;
  }
  const notification = new Notification(title, {body: text, tag: uid, icon: plainIcon, lang: document.documentElement.lang});
  notification.addEventListener('click', () => {
    focus();
    location.href = bell.href;
  });
}
