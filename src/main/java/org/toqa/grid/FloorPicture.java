package org.toqa.grid;

import java.util.BitSet;
import java.util.Map;
import org.toqa.geometry.Vec2;

/** Reads a plan of a floor that somebody has drawn or scanned: a PNG picture, one pixel a cell. */
public final class FloorPicture {
  private FloorPicture() {}

  /**
   * The walls of the picture, with its lower left corner at the frame's origin. What is transparent
   * is paper, and free.
   *
   * @param name of its file, for sentences
   * @param resolution metres that a pixel is wide
   * @param threshold from 0 to 1: what is darker, between black and white, is a wall
   */
  public static FloorDrawing read(String name, byte[] png, double resolution, double threshold)
      throws MapFormatException {
    if (!(resolution >= MapLimits.FINEST && resolution <= MapLimits.COARSEST)) {
      throw new MapFormatException(
          "A pixel of the picture is from 0.001 to 100 m wide, not " + resolution + ".");
    }
    GreyImage image = PngReader.read(new MapFile.InArchive(MapArchive.of(Map.of(name, png)), name));
    int cells = image.width() * image.height();
    BitSet occupied = new BitSet(cells);
    for (int i = 0; i < cells; i++) {
      occupied.set(i, image.shades().at(i) < threshold); // NaN is not below
    }
    return FloorDrawing.of(
        new OccupancyGrid(image.width(), image.height(), resolution, Vec2.ZERO, occupied));
  }
}
