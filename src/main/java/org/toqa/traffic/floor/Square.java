package org.toqa.traffic.floor;

import java.util.function.Consumer;

/** One of the squares of a metre by which areas on a floor are found. */
record Square(int column, int row) {
  private static final double SIDE = 1;

  /**
   * Names all squares that an area is in, or so near to, metres; perhaps some beside them.
   *
   * @param around metres
   */
  static void forEach(SweptArea area, double around, Consumer<Square> consumer) {
    int lastColumn = index(area.east() + around);
    int lastRow = index(area.north() + around);
    for (int column = index(area.west() - around); column <= lastColumn; column++) {
      for (int row = index(area.south() - around); row <= lastRow; row++) {
        consumer.accept(new Square(column, row));
      }
    }
  }

  private static int index(double metres) {
    return (int) Math.floor(metres / SIDE);
  }
}
