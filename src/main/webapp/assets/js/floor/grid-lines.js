/**
 * Draws the borders of the cells that the canvas shows.
 *
 * @param grid its left upper corner and a cell's side in pixels, its width and height in cells
 */
export function drawGridLines(context, viewport, colours, {left, top, cell, width, height}) {
  context.beginPath();
  for (let column = 1; column < width; column++) {
    const x = Math.round(left + column * cell) + 0.5;
    if (x > 0 && x < viewport.width) {
      context.moveTo(x, Math.max(0, top));
      context.lineTo(x, Math.min(viewport.height, top + height * cell));
    }
  }
  for (let row = 1; row < height; row++) {
    const y = Math.round(top + row * cell) + 0.5;
    if (y > 0 && y < viewport.height) {
      context.moveTo(Math.max(0, left), y);
      context.lineTo(Math.min(viewport.width, left + width * cell), y);
    }
  }
  context.strokeStyle = colours['map-line'];
  context.lineWidth = 1;
  context.stroke();
}
