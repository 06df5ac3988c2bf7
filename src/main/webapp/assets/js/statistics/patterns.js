const SIZE = 8; // pixels of a tile

/** What is drawn in a tile upon the colour, one for each place in the row; the first is plain. */
const HATCHINGS = [
  () => {},
  (pen) => strokes(pen, [[0, SIZE, SIZE, 0], [-1, 1, 1, -1], [SIZE - 1, SIZE + 1, SIZE + 1, SIZE - 1]]),
  (pen) => pen.fillRect(2, 2, 4, 4),
  (pen) => strokes(pen, [[0, 0, SIZE, SIZE], [-1, SIZE - 1, 1, SIZE + 1], [SIZE - 1, -1, SIZE + 1, 1]]),
  (pen) => strokes(pen, [[0, SIZE / 2, SIZE, SIZE / 2]]),
  (pen) => strokes(pen, [[SIZE / 2, 0, SIZE / 2, SIZE]]),
  (pen) => strokes(pen, [[0, 0, SIZE, SIZE], [0, SIZE, SIZE, 0]]),
  (pen) => pen.fillRect(0, 0, SIZE / 2, SIZE),
];

/** A fill that can be told from the others without its colour. */
export function createPattern(colour, ground, index) {
  const tile = document.createElement('canvas');
  tile.width = SIZE;
  tile.height = SIZE;
  const pen = tile.getContext('2d');
  pen.fillStyle = colour;
  pen.fillRect(0, 0, SIZE, SIZE);
  pen.fillStyle = ground;
  pen.strokeStyle = ground;
  pen.lineWidth = 1.5;
  HATCHINGS[index % HATCHINGS.length](pen);
  return pen.createPattern(tile, 'repeat');
}

function strokes(pen, lines) {
  pen.beginPath();
  for (const [x, y, toX, toY] of lines) {
    pen.moveTo(x, y);
    pen.lineTo(toX, toY);
  }
  pen.stroke();
}
