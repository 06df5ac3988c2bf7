import '../shared/live.js';
import {zone} from '../shared/time-zone.js';
import {drawChart} from './chart.js';

/** Days begin at the reader's own midnight, unless the address names another time zone. */
const page = new URL(location.href);
if (page.searchParams.has('zone')) {
  showCharts();
} else {
  page.searchParams.set('zone', zone);
  location.replace(page);
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
