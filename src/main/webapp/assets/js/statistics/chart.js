import '../../chart/chart.umd.min.js'; // defines the global Chart
import {createPattern} from './patterns.js';
import {locale} from '../shared/locale.js';

const isRightToLeft = document.dir === 'rtl';

/** Dashes and points, by which lines differ without their colours. */
const LINES = [
  {borderDash: [], pointStyle: 'circle'},
  {borderDash: [6, 4], pointStyle: 'rect'},
];

/** How numbers of a unit are formatted: by the first scale of which the largest number has at least two. */
const SCALES = {
  COUNT: [{of: 1, as: {}}],
  SHARE: [{of: 1, as: {style: 'percent', maximumFractionDigits: 1}}],
  METRES: [
    {of: 1000, as: {style: 'unit', unit: 'kilometer', maximumFractionDigits: 2}},
    {of: 1, as: {style: 'unit', unit: 'meter', maximumFractionDigits: 2}},
  ],
  SECONDS: [
    {of: 3600, as: {style: 'unit', unit: 'hour', maximumFractionDigits: 2}},
    {of: 60, as: {style: 'unit', unit: 'minute', maximumFractionDigits: 2}},
    {of: 1, as: {style: 'unit', unit: 'second', maximumFractionDigits: 2}},
  ],
};

/** Draws the table of an article into its canvas; the table stays on the page for screen readers. */
export function drawChart(article) {
  const table = article.querySelector('table');
  const rows = [...table.querySelectorAll('tbody tr')];
  const columns = [...table.querySelectorAll('thead th')].slice(1)
    .map((head, index) => ({...head.dataset, title: head.textContent, values: valuesOf(rows, index), head}))
    .filter(({shape, values}) => shape !== 'NONE' && values.some((value) => value));
  const isHorizontal = 'horizontal' in article.dataset;
  if (isHorizontal) {
    article.querySelector('.plot').style.blockSize = `${9 + 2 * rows.length}rem`;
  }
  const {Chart} = globalThis;
  const colours = coloursOf(article);
  Chart.defaults.color = colours.text;
  Chart.defaults.font.family = colours.font;
  return new Chart(article.querySelector('canvas'), {
    type: columns.some(({shape}) => shape === 'BAR') ? 'bar' : 'line',
    data: {
      labels: rows.map((row) => row.querySelector('th').textContent),
      datasets: datasetsOf(columns, scaleOf(columns), colours),
    },
    options: optionsOf(columns, scaleOf(columns), isHorizontal, colours),
  });
}

function valuesOf(rows, index) {
  return rows
    .map((row) => row.querySelectorAll('td')[index].dataset.value)
    .map((value) => (value === '' ? null : Number(value)));
}

function scaleOf(columns) {
  const largest = Math.max(...columns.flatMap(({values}) => values));
  const scales = SCALES[columns[0].unit];
  return scales.find((scale) => largest >= 2 * scale.of) ?? scales.at(-1);
}

function datasetsOf(columns, scale, colours) {
  const count = {BAR: 0, LINE: 0};
  return columns.map(({title, shape, values, head}) => {
    const colour = getComputedStyle(head).getPropertyValue('--series').trim();
    const index = count[shape]++;
    return {
      label: title,
      data: values.map((value) => value === null ? null : value / scale.of),
      ...(shape === 'BAR' ? bar(colour, colours.page, index) : line(colour, index)),
    };
  });
}

function bar(colour, page, index) {
  return {
    type: 'bar',
    stack: 'all',
    order: 1,
    backgroundColor: createPattern(colour, page, index),
    borderColor: colour,
    borderWidth: 1,
    maxBarThickness: 48,
    pointStyle: 'rect',
  };
}

function line(colour, index) {
  return {
    type: 'line',
    order: 0,
    backgroundColor: colour,
    borderColor: colour,
    borderWidth: 2,
    pointRadius: 3,
    ...LINES[index % LINES.length],
  };
}

function optionsOf(columns, scale, isHorizontal, colours) {
  const number = new Intl.NumberFormat(locale, scale.as);
  const ofRows = {
    reverse: isRightToLeft && !isHorizontal,
    stacked: true,
    grid: {display: false},
    border: {color: colours.line},
  };
  const ofValues = {
    reverse: isRightToLeft && isHorizontal,
    stacked: columns.some(({shape}) => shape === 'BAR'),
    beginAtZero: true,
    max: isHorizontal ? 1 : undefined,
    grid: {color: colours.line},
    border: {display: false},
    ticks: {callback: (value) => number.format(value), precision: columns[0].unit === 'COUNT' ? 0 : undefined},
  };
  return {
    animation: false,
    maintainAspectRatio: false,
    locale,
    indexAxis: isHorizontal ? 'y' : 'x',
    interaction: {mode: 'index', intersect: false, axis: isHorizontal ? 'y' : 'x'},
    scales: isHorizontal ? {x: ofValues, y: ofRows} : {x: ofRows, y: ofValues},
    plugins: {
      legend: {
        display: columns.length > 1,
        position: 'bottom',
        rtl: isRightToLeft,
        labels: {usePointStyle: true, boxHeight: 9, pointStyleWidth: columns.every(({shape}) => shape === 'BAR') ? 20 : undefined, padding: 14},
      },
      tooltip: {
        rtl: isRightToLeft,
        callbacks: {label: ({dataset, raw}) => `${dataset.label}: ${raw === null ? '–' : number.format(raw)}`},
      },
    },
  };
}

/** Colours and the font of the style sheet. */
function coloursOf(article) {
  const style = getComputedStyle(article);
  return {
    text: style.getPropertyValue('--faint').trim(),
    line: style.getPropertyValue('--line').trim(),
    page: style.getPropertyValue('--map-free').trim(),
    font: style.fontFamily,
  };
}
