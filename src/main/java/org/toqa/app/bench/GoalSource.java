package org.toqa.app.bench;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.random.RandomGenerator;
import org.toqa.grid.Cell;

/** Where robots are sent next. */
interface GoalSource {

  /**
   * The robot's next goal, other than where it is; empty where it has reached all.
   *
   * @param robot its index, from 0
   * @param at where it is
   */
  Optional<Cell> next(int robot, Cell at);

  /**
   * Any other of some cells, each as likely.
   *
   * @param cells at least two different ones
   */
  static GoalSource random(List<Cell> cells, RandomGenerator random) {
    return (robot, at) -> {
      Cell goal = at;
      while (goal.equals(at)) {
        goal = cells.get(random.nextInt(cells.size()));
      }
      return Optional.of(goal);
    };
  }

  /**
   * A list for each robot, one goal after the other.
   *
   * @param tasks in the order of the robots' indices
   */
  static GoalSource ofLists(List<RobotGoals> tasks) {
    List<Queue<Cell>> goals =
        tasks.stream().<Queue<Cell>>map(list -> new ArrayDeque<>(list.goals())).toList();
    return (robot, at) -> {
      Queue<Cell> left = goals.get(robot);
      while (at.equals(left.peek())) {
        left.remove();
      }
      return Optional.ofNullable(left.poll());
    };
  }
}
