/** The reader's own time zone, in which times are entered as they are shown. */
export const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;

document.querySelector('#zone').value = zone;
const name = document.querySelector('#zone-name');
if (name) {
  name.textContent = zone;
}
