package org.toqa.app.command;

import picocli.CommandLine.Option;

/** {@code --moves}: what a path may consist of. */
public final class MovesOption {
  @Option(
      names = "--moves",
      paramLabel = "octile|heading",
      converter = MoveSet.Converter.class,
      description =
          "octile: moves to any of the eight neighbours; heading: moves that a robot can drive in"
              + " arcs (default: ${DEFAULT-VALUE}).")
  private MoveSet moves;

  /**
   * @param defaultMoves where the option is not given
   */
  public MovesOption(MoveSet defaultMoves) {
    moves = defaultMoves;
  }

  public MoveSet value() {
    return moves;
  }
}
