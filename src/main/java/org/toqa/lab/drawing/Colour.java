package org.toqa.lab.drawing;

/** What pictures are drawn with; the first ones are told apart by people who see few colours. */
public enum Colour {
  BLUE("#1c66d6"),
  ORANGE("#b35900"),
  GREEN("#17704a"),
  RED("#b3261e"),
  PURPLE("#7a3fb5"),
  GREY("#8a94a6"),
  LIGHT("#c9d1de"),
  WALL("#44506a");

  static final String PAGE = "#f4f6fa";
  static final String GROUND = "#ffffff";
  static final String TEXT = "#1f2a3d";

  private final String code;

  Colour(String code) {
    this.code = code;
  }

  /** As style sheets and SVG write it. */
  public String code() {
    return code;
  }

  /**
   * One for each line of a chart, in turn.
   *
   * @param index from 0
   */
  public static Colour ofLine(int index) {
    return values()[Math.floorMod(index, 5)];
  }
}
