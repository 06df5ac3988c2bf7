/** The cells of a straight line between two cells (Bresenham). */
export function* lineOf(from, to) {
  const [dx, dy] = [Math.abs(to.column - from.column), -Math.abs(to.row - from.row)];
  const [sx, sy] = [Math.sign(to.column - from.column), Math.sign(to.row - from.row)];
  let {column, row} = from;
  let error = dx + dy;
  for (;;) {
    yield {column, row};
    if (column === to.column && row === to.row) {
      return;
    }
    const twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      column += sx;
    }
    if (twice <= dx) {
      error += dx;
      row += sy;
    }
  }
}

/** The rectangle that two cells span: its first and last column and row. */
export function boxOf(a, b) {
  return {
    left: Math.min(a.column, b.column),
    right: Math.max(a.column, b.column),
    top: Math.min(a.row, b.row),
    bottom: Math.max(a.row, b.row),
  };
}

export function* cellsOf({left, right, top, bottom}) {
  for (let row = top; row <= bottom; row++) {
    for (let column = left; column <= right; column++) {
      yield {column, row};
    }
  }
}

export function* outlineOf({left, right, top, bottom}) {
  yield* lineOf({column: left, row: top}, {column: right, row: top});
  yield* lineOf({column: left, row: bottom}, {column: right, row: bottom});
  yield* lineOf({column: left, row: top}, {column: left, row: bottom});
  yield* lineOf({column: right, row: top}, {column: right, row: bottom});
}

/** Each of these cells as a square of so many cells round it. */
export function* widened(cells, width) {
  const before = Math.floor((width - 1) / 2);
  for (const {column, row} of cells) {
    yield* cellsOf({
      left: column - before, right: column - before + width - 1,
      top: row - before, bottom: row - before + width - 1,
    });
  }
}
