package org.toqa.app.command;

import java.util.Locale;
import java.util.function.LongConsumer;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanChecker.Rule;

/** {@code --moves}: what a path may consist of, and who plans it. */
public enum MoveSet {
  /** To any of the eight neighbours, whatever the corners. */
  OCTILE(Rule.OCTILE) {
    @Override
    public PathPlanner planner(LongConsumer expansionListener) {
      return new JumpPointSearch(expansionListener);
    }
  },

  /** What a robot can drive in arcs; turns on the spot only where there is no other path. */
  HEADING(Rule.HEADING) {
    @Override
    public PathPlanner planner(LongConsumer expansionListener) {
      return new HeadingAStar(expansionListener);
    }
  };

  private final Rule rule;

  MoveSet(Rule rule) {
    this.rule = rule;
  }

  /**
   * A planner of such paths.
   *
   * @param expansionListener is told after each search how many states it has expanded
   */
  public abstract PathPlanner planner(LongConsumer expansionListener);

  /** What the checker holds such a path to. */
  public Rule rule() {
    return rule;
  }

  /** As a user types it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Reads what a user types. */
  public static final class Converter extends WordConverter<MoveSet> {
    public Converter() {
      super(values());
    }
  }
}
