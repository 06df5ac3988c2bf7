package org.toqa.allocation;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Trade between robots that have a task each and have not begun it: one passes its task to a robot
 * without one, or two change theirs, wherever that lowers the sum of their costs (TraderBots: Dias,
 * 2004). Every trade lowers the sum by at least {@link #LEAST_SAVING}, so it comes to an end.
 */
final class Exchange {
  /** Joules: what half a metre costs. */
  static final double LEAST_SAVING = Energy.joules(0.5, 0);

  private final double[][] joules;
  private final int[] robotOf;
  private final BitSet engaged = new BitSet();

  /**
   * @param joules by job and robot
   * @param robotOf the robot that has each job
   */
  private Exchange(double[][] joules, int[] robotOf) {
    this.joules = joules;
    this.robotOf = robotOf.clone();
    Arrays.stream(robotOf).forEach(engaged::set);
  }

  /**
   * @param robotOf by job, the robot that has it, as an index of {@code robots}
   * @return the same after the trade
   */
  static int[] trade(
      Costs costs, List<AllocationTask> tasks, List<Candidate> robots, int[] robotOf) {
    double[][] joules =
        tasks.stream()
            .map(task -> costs.of(task, robots).stream().mapToDouble(Costs.Cost::joules).toArray())
            .toArray(double[][]::new);
    Exchange exchange = new Exchange(joules, robotOf);
    boolean traded;
    do {
      traded = exchange.passTasks();
      traded |= exchange.swapTasks();
    } while (traded);
    return exchange.robotOf;
  }

  private boolean passTasks() {
    boolean traded = false;
    for (int task = 0; task < robotOf.length; task++) {
      for (int robot = 0; robot < joules[task].length; robot++) {
        double saved = joules[task][robotOf[task]] - joules[task][robot];
        if (!engaged.get(robot) && saved >= LEAST_SAVING) {
          engaged.clear(robotOf[task]);
          engaged.set(robot);
          robotOf[task] = robot;
          traded = true;
        }
      }
    }
    return traded;
  }

  private boolean swapTasks() {
    boolean traded = false;
    for (int a = 0; a < robotOf.length; a++) {
      for (int b = a + 1; b < robotOf.length; b++) {
        int robotA = robotOf[a];
        int robotB = robotOf[b];
        double before = joules[a][robotA] + joules[b][robotB];
        double after = joules[a][robotB] + joules[b][robotA];
        if (before - after >= LEAST_SAVING) {
          robotOf[a] = robotB;
          robotOf[b] = robotA;
          traded = true;
        }
      }
    }
    return traded;
  }
}
