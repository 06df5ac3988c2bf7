package org.toqa.grid;

/** What a map may be at most; checked before memory is taken for it. */
public final class MapLimits {
  /** 17 million cells: 4096 x 4096, or 200 m x 200 m at 0.05 m. */
  public static final int MAX_CELLS = 1 << 24;

  /** Bytes of an image or of a map in text. */
  public static final long MAX_MAP_BYTES = 64L << 20;

  /** Bytes of a YAML file from anywhere. */
  static final int MAX_YAML_BYTES = 1 << 20;

  /**
   * Of one that was written here: more than all kinds of places and areas with the longest names.
   */
  static final int MAX_STORED_YAML_BYTES = 1 << 23;

  /** Metres of a cell's side. */
  public static final double FINEST = 0.001;

  /** Metres of a cell's side. */
  public static final double COARSEST = 100;

  /** Metres from the frame's origin. */
  public static final double FARTHEST = 100_000;

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
