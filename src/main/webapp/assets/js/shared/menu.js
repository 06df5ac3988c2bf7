/** The menu that opens closes again by Escape, and when something beside it is chosen. */
const menu = document.querySelector('.top .more');
const close = () => {
  menu.open = false;
};
addEventListener('click', ({target}) => menu.contains(target) || close());
menu.addEventListener('focusout', ({relatedTarget}) => {
  if (relatedTarget && !menu.contains(relatedTarget)) {
    close();
  }
});
menu.addEventListener('keydown', ({key}) => {
  if (key === 'Escape' && menu.open) {
    close();
    menu.querySelector('summary').focus();
  }
});
