/** Of what the page says above all, the most urgent is shown, and how much more there is: it opens. */
const place = document.getElementById('banners');
const more = document.getElementById('more-banners');
let isOpen = false;

function arrange() {
  const banners = [...place.querySelectorAll('.notice')].filter((banner) => !banner.hidden);
  banners.forEach((banner, i) => banner.classList.toggle('later', i > 0 && !isOpen));
  more.hidden = banners.length < 2;
  more.ariaExpanded = isOpen;
  more.textContent = isOpen
    ? more.dataset.less
    : more.dataset.more.replace('{0}', new Intl.NumberFormat(document.documentElement.lang).format(banners.length - 1));
}

more.addEventListener('click', () => {
  isOpen = !isOpen;
  arrange();
});
new MutationObserver(arrange).observe(place, {subtree: true, childList: true, attributeFilter: ['hidden']});
arrange();
