package org.toqa.traffic.mapf;

import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/** Reservations where a vertex counts as taken while one too near to it is. */
final class SpacedReservations extends ReservationTable {
  private final Spacing spacing;

  SpacedReservations(RoadGraph roads, Spacing spacing, int steps) {
    super(roads, steps);
    this.spacing = spacing;
  }

  @Override
  public boolean isTaken(int vertex, int time) {
    if (super.isTaken(vertex, time)) {
      return true;
    }
    for (int other : spacing.near(vertex)) {
      if (super.isTaken(other, time)) {
        return true;
      }
    }
    return false;
  }

  @Override
  int nextFree(int vertex, int time) {
    int free = time;
    while (true) {
      int next = super.nextFree(vertex, free);
      for (int other : spacing.near(vertex)) {
        next = super.nextFree(other, next);
      }
      if (next == free || next >= end()) {
        return next;
      }
      free = next;
    }
  }

  @Override
  int nextTaken(int vertex, int time) {
    int taken = super.nextTaken(vertex, time);
    for (int other : spacing.near(vertex)) {
      taken = Math.min(taken, super.nextTaken(other, time));
    }
    return taken;
  }

  @Override
  int nextFreeEdge(int vertex, int direction, int time) {
    int free = time;
    while (true) {
      int next = free;
      for (int edge : spacing.opposite(beside(vertex, direction), RoadGraph.opposite(direction))) {
        next = super.nextFreeEdge(edge / RoadGraph.DIRECTIONS, edge % RoadGraph.DIRECTIONS, next);
      }
      if (next == free || next >= end()) {
        return next;
      }
      free = next;
    }
  }

  @Override
  int freeSince(int vertex, int time) {
    int since = super.freeSince(vertex, time);
    for (int other : spacing.near(vertex)) {
      since = Math.max(since, super.freeSince(other, time));
    }
    return since;
  }
}
