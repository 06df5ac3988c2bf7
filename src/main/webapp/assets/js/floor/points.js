/** Draws a path that nobody drives yet, dashed. */
export function drawPath(context, viewport, colours, path) {
  context.strokeStyle = colours['map-goal'];
  context.lineWidth = 2.5;
  context.lineJoin = 'round';
  context.setLineDash([7, 5]);
  context.beginPath();
  path.forEach(({x, y}) => context.lineTo(...viewport.toScreen(x, y)));
  context.stroke();
  context.setLineDash([]);
}

/** Draws where a way begins, a square, or ends, a circle. */
export function drawPoint(context, viewport, colours, isStart, point) {
  const [x, y] = viewport.toScreen(point.x, point.y);
  context.beginPath();
  if (isStart) {
    context.roundRect(x - 8, y - 8, 16, 16, 3);
    context.fillStyle = colours['map-load'];
    context.strokeStyle = colours['map-load-line'];
    context.fill();
  } else {
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.strokeStyle = colours['map-goal'];
  }
  context.lineWidth = 2.5;
  context.stroke();
}
