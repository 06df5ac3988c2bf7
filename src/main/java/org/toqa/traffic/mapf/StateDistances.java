package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import org.toqa.traffic.DistanceTables;

/** Steps from every state to a goal, turns counted, others not: breadth-first search. */
public final class StateDistances {
  private StateDistances() {}

  /**
   * @param goal a vertex, reached in any heading
   * @return by state; {@link DistanceTables#UNREACHABLE} where there is no path
   */
  public static char[] to(StateGraph graph, int goal) {
    char[] steps = new char[graph.stateCount()];
    Arrays.fill(steps, (char) DistanceTables.UNREACHABLE);
    int[] queue = new int[graph.stateCount()];
    int tail = 0;
    for (int heading = 0; heading < graph.headingCount(); heading++) {
      int state = graph.state(goal, heading);
      steps[state] = 0;
      queue[tail++] = state;
    }
    for (int head = 0; head < tail; head++) {
      int next = steps[queue[head]] + 1;
      for (int action = 1;
          action < graph.actionCount() && next < DistanceTables.UNREACHABLE;
          action++) {
        int state = graph.predecessor(queue[head], action);
        if (state != NONE && steps[state] == DistanceTables.UNREACHABLE) {
          steps[state] = (char) next;
          queue[tail++] = state;
        }
      }
    }
    return steps;
  }
}
