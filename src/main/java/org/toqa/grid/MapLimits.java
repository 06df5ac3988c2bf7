package org.toqa.grid;

/** What a map file may be at most; checked before memory is taken for it. */
final class MapLimits {
  /** 17 million cells: 4096 x 4096, or 200 m x 200 m at 0.05 m. */
  static final int MAX_CELLS = 1 << 24;

  /** Bytes of an image or of a map in text. */
  static final long MAX_MAP_BYTES = 64L << 20;

  /** Bytes of a YAML file. */
  static final long MAX_YAML_BYTES = 1L << 20;

  /** Metres from the frame's origin. */
  static final double FARTHEST = 100_000;

  private MapLimits() {}

  static void checkSize(MapFile file, long width, long height) throws MapFormatException {
    if (width < 1 || height < 1) {
      throw new MapFormatException(
          file + ": the map is " + width + " x " + height + " cells; both must be at least 1.");
    }
    if (width > MAX_CELLS || height > MAX_CELLS || width * height > MAX_CELLS) {
      throw new MapFormatException(
          "%s: the map is %d x %d cells, more than %d; use larger cells or split the floor."
              .formatted(file, width, height, MAX_CELLS));
    }
  }
}
