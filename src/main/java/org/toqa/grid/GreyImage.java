package org.toqa.grid;

/**
 * A picture in shades of grey.
 *
 * @param shades 0 black to 1 white, row by row from the top; NaN where transparent
 */
record GreyImage(int width, int height, Shades shades) {

  /** One shade a pixel, by {@code row * width + column}. */
  @FunctionalInterface
  interface Shades {
    double at(int index);
  }
}
