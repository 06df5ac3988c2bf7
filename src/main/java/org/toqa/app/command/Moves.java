package org.toqa.app.command;

import java.util.function.LongConsumer;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanChecker.Rule;

/** {@code --moves}: what a way may consist of, and who plans it. */
public enum Moves {
  /** To any of the eight neighbours, whatever the corners. */
  OCTILE(Rule.OCTILE) {
    @Override
    public PathPlanner planner(LongConsumer effort) {
      return new JumpPointSearch(effort);
    }
  },

  /** What a robot can drive in arcs; turns on the spot only where there is no other way. */
  HEADING(Rule.HEADING) {
    @Override
    public PathPlanner planner(LongConsumer effort) {
      return new HeadingAStar(effort);
    }
  };

  private final Rule rule;

  Moves(Rule rule) {
    this.rule = rule;
  }

  /**
   * @param effort is told after each search how many states it has expanded
   */
  public abstract PathPlanner planner(LongConsumer effort);

  /** What the checker holds such a way to. */
  public Rule rule() {
    return rule;
  }

  /** Reads what a user types. */
  public static final class Converter extends WordConverter<Moves> {
    public Converter() {
      super(values());
    }
  }
}
