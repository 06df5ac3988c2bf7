package org.toqa.traffic.oneshot;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.SplittableRandom;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;

final class NeighbourhoodSearch {
  private static final int STRATEGIES = 3;
  private final RoadGraph roads;
  private final char[][] distances;
  private final int[][] routes;
  private final int[] goals;
  private final Timetable timetable;
  private final SafeIntervalSearch search;
  private final SplittableRandom random;
  private final boolean[] isChosen;
  private final int[] chosen;
  private int chosenCount;
  long tries, wins;

  NeighbourhoodSearch(
      RoadGraph roads, char[][] distances, int[][] routes, SplittableRandom random) {
    this.roads = roads;
    this.distances = distances;
    this.routes = routes;
    this.random = random;
    int makespan = 0;
    goals = new int[routes.length];
    for (int i = 0; i < routes.length; i++) {
      makespan = Math.max(makespan, routes[i].length);
      goals[i] = routes[i][routes[i].length - 1];
    }
    timetable = new Timetable(roads, makespan + makespan / 4 + 64);
    for (int[] r : routes) timetable.add(r);
    search = new SafeIntervalSearch(roads, timetable);
    isChosen = new boolean[routes.length];
    chosen = new int[routes.length];
  }

  void run(Deadline deadline, int minSize, int maxSize) {
    int[][] old = new int[routes.length][];
    while (!deadline.isPassed()) {
      tries++;
      chosenCount = 0;
      int size = Math.min(routes.length, minSize + random.nextInt(maxSize - minSize + 1));
      int strategy = random.nextInt(10);
      if (strategy < 6) walk(size);
      while (chosenCount < size) choose(random.nextInt(routes.length));
      shuffle();
      long oldSum = 0, rest = 0;
      for (int k = 0; k < chosenCount; k++) {
        int r = chosen[k];
        isChosen[r] = false;
        old[k] = routes[r];
        timetable.remove(old[k]);
        oldSum += old[k].length - 1;
        rest += distances[r][old[k][0]];
      }
      long sum = 0;
      int k = 0;
      for (; k < chosenCount; k++) {
        int r = chosen[k];
        int lb = distances[r][old[k][0]];
        rest -= lb;
        int[] route =
            search.route(
                old[k][0], goals[r], distances[r], (int) Math.min(oldSum - sum - rest, 60000));
        if (route == null) break;
        sum += route.length - 1;
        timetable.add(route);
        routes[r] = route;
      }
      if (k < chosenCount) {
        for (int j = 0; j < chosenCount; j++) {
          if (j < k) timetable.remove(routes[chosen[j]]);
          routes[chosen[j]] = old[j];
        }
        for (int j = 0; j < chosenCount; j++) timetable.add(old[j]);
      } else if (sum < oldSum) wins++;
    }
  }

  private void choose(int r) {
    if (!isChosen[r]) {
      isChosen[r] = true;
      chosen[chosenCount++] = r;
    }
  }

  private int delay(int r) {
    return routes[r].length - 1 - distances[r][routes[r][0]];
  }

  private void walk(int size) {
    int seed = random.nextInt(routes.length);
    for (int k = 0; k < 3; k++) {
      int other = random.nextInt(routes.length);
      if (delay(other) > delay(seed)) seed = other;
    }
    choose(seed);
    for (int tries = 0; tries < 10 && chosenCount < size; tries++) {
      int r = chosen[random.nextInt(chosenCount)];
      int t = random.nextInt(routes[r].length);
      int v = routes[r][t];
      int latest = routes[r].length - 1;
      for (; chosenCount < size; t++) {
        int pick = NONE, options = 0;
        for (int d = 0; d <= DIRECTIONS; d++) {
          int u = d == DIRECTIONS ? v : roads.neighbour(v, d);
          if (u != NONE && t + 1 + distances[r][u] < latest && random.nextInt(++options) == 0)
            pick = u;
        }
        if (pick == NONE) break;
        v = pick;
        if (timetable.isTaken(v, t + 1)) {
          for (int i = 0; i < routes.length; i++)
            if (routes[i][Math.min(t + 1, routes[i].length - 1)] == v) choose(i);
        }
      }
    }
  }

  private void shuffle() {
    for (int k = chosenCount - 1; k > 0; k--) {
      int j = random.nextInt(k + 1);
      int s = chosen[k];
      chosen[k] = chosen[j];
      chosen[j] = s;
    }
  }
}
