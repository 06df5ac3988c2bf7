import {drawLabel} from '../floor/labels.js';

/** The zones of the load-based allocator: every other one is tinted; each has its number and its robot. */
export function drawZones(context, viewport, colours, zones) {
  zones.forEach(({robot, low, high}, i) => {
    const [left, bottom] = viewport.toScreen(low.x, low.y);
    const [right, top] = viewport.toScreen(high.x, high.y);
    context.globalAlpha = i % 2 === 0 ? 0.14 : 0.05;
    context.fillStyle = colours['map-goal'];
    context.fillRect(left, top, right - left, bottom - top);
    context.globalAlpha = 0.8;
    context.strokeStyle = colours['map-goal'];
    context.lineWidth = 1.5;
    context.setLineDash([6, 5]);
    context.strokeRect(left, top, right - left, bottom - top);
    context.setLineDash([]);
    context.globalAlpha = 1;
    drawLabel(context, colours, `${i + 1} · ${robot}`, (left + right) / 2, bottom - 6, 'bottom');
  });
}
