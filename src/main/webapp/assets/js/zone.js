/** Times are entered in the reader's own time zone, as they are shown. */
const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;

document.querySelector('#zone').value = zone;
const name = document.querySelector('#zone-name');
if (name) {
  name.textContent = zone;
}
