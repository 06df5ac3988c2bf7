import '../shared/live.js';
import '../shared/time-zone.js';
import {text} from '../shared/texts.js';
import {playSound} from './sound.js';

const state = document.querySelector('#browser-state');
const allow = document.querySelector('#allow');
const sound = document.querySelector('#try-sound');

/** What the browser says of notifications of this site. */
function showPermission() {
  const permission = !window.isSecureContext || !('Notification' in window) ? 'impossible' : Notification.permission;
  state.textContent = text(`notices.browser.${permission}`);
  allow.hidden = permission !== 'default';
}

allow.addEventListener('click', async () => {
  await Notification.requestPermission();
  showPermission();
});

sound.hidden = false;
sound.addEventListener('click', () => playSound());
showPermission();
