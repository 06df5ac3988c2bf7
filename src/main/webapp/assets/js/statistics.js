import './live.js';
import {drawChart} from './chart.js';
import {zone} from './zone.js';

/** Days begin at the reader's own midnight, unless the address says another zone. */
const place = new URL(location.href);
if (place.searchParams.has('zone')) {
  showCharts();
} else {
  place.searchParams.set('zone', zone);
  location.replace(place);
}

function showCharts() {
  const articles = [...document.querySelectorAll('article.chart:has(canvas)')];
  let charts = [];
  const draw = () => {
    charts.forEach((chart) => chart.destroy());
    charts = articles.map(drawChart);
  };
  draw();
  articles.forEach((article) => { article.querySelector('details').open = false; });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
}
