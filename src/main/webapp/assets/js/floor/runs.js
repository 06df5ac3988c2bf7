/**
 * Runs of cells as the API gives them (index of the first one, number of cells, and so on by turns), cut where a row
 * ends.
 *
 * @param width cells in a row
 */
export function* rowsOf(runs, width) {
  for (let i = 0; i < runs.length; i += 2) {
    let [cell, left] = [runs[i], runs[i + 1]];
    while (left > 0) {
      const column = cell % width;
      const count = Math.min(left, width - column);
      yield {column, row: Math.floor(cell / width), count};
      cell += count;
      left -= count;
    }
  }
}
