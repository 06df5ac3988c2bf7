package org.toqa.app.bench;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.random.RandomGenerator;
import org.toqa.grid.Cell;

/** Where robots are sent next. */
interface GoalSource {

  /** The robot's next goal, other than where it is; empty where it has done all. */
  Optional<Cell> next(int robot, Cell at);

  /** Any other of some cells, each as likely. */
  static GoalSource random(List<Cell> cells, RandomGenerator random) {
    return (robot, at) -> {
      Cell goal = at;
      while (goal.equals(at)) {
        goal = cells.get(random.nextInt(cells.size()));
      }
      return Optional.of(goal);
    };
  }

  /** A list a robot, one goal after the other. */
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
