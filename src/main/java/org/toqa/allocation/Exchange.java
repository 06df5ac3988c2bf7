package org.toqa.allocation;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Trade between robots that have a task each and have not begun it: one passes its task to a robot
 * without one, or two change theirs, wherever that lowers the sum of their costs (TraderBots: Dias,
 * 2004). Every trade lowers the sum by at least {@link #WORTHWHILE}, so it comes to an end.
 */
final class Exchange {
  /** Joules: what half a metre costs. */
  static final double WORTHWHILE = Energy.joules(0.5, 0);

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
  static int[] trade(Costs costs, List<Job> jobs, List<Candidate> robots, int[] robotOf) {
    double[][] joules =
        jobs.stream()
            .map(job -> costs.of(job, robots).stream().mapToDouble(Costs.Cost::joules).toArray())
            .toArray(double[][]::new);
    Exchange exchange = new Exchange(joules, robotOf);
    boolean traded;
    do {
      traded = exchange.passOn();
      traded |= exchange.swap();
    } while (traded);
    return exchange.robotOf;
  }

  private boolean passOn() {
    boolean traded = false;
    for (int job = 0; job < robotOf.length; job++) {
      for (int robot = 0; robot < joules[job].length; robot++) {
        double saved = joules[job][robotOf[job]] - joules[job][robot];
        if (!engaged.get(robot) && saved >= WORTHWHILE) {
          engaged.clear(robotOf[job]);
          engaged.set(robot);
          robotOf[job] = robot;
          traded = true;
        }
      }
    }
    return traded;
  }

  private boolean swap() {
    boolean traded = false;
    for (int a = 0; a < robotOf.length; a++) {
      for (int b = a + 1; b < robotOf.length; b++) {
        int robotA = robotOf[a];
        int robotB = robotOf[b];
        double before = joules[a][robotA] + joules[b][robotB];
        double after = joules[a][robotB] + joules[b][robotA];
        if (before - after >= WORTHWHILE) {
          robotOf[a] = robotB;
          robotOf[b] = robotA;
          traded = true;
        }
      }
    }
    return traded;
  }
}
