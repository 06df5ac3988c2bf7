package org.toqa.fleet.history;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;

/**
 * Where robots have seen what the map does not show, also after the floor has forgotten it: what
 * many have seen for long is offered as a change of the map. A place where a robot has stood since
 * counts no more. It knows no clock: time is handed in. Any thread may call it.
 */
public final class SeenPlaces {
  /** From the first to the last time that something was seen there. */
  public static final Duration OFFER_AFTER = Duration.ofHours(1);

  /** Different ones. */
  public static final int LEAST_ROBOTS = 2;

  /** Without being seen again. */
  static final Duration FORGET_AFTER = Duration.ofDays(7);

  private static final int PER_METRE = 1000;

  private final Map<Spot, Sighting> sightings = new HashMap<>();
  private boolean changed;

  /**
   * The middle of a cell, which stays where it is when the floor gets another map.
   *
   * @param x millimetres, map frame
   * @param y millimetres, map frame
   */
  public record Spot(String floor, int x, int y) {
    static Spot of(FloorMap floor, Cell cell) {
      Vec2 centre = floor.grid().centre(cell);
      return new Spot(
          floor.name(),
          Math.toIntExact(Math.round(centre.x() * PER_METRE)),
          Math.toIntExact(Math.round(centre.y() * PER_METRE)));
    }

    Vec2 position() {
      return new Vec2(x, y).times(1.0 / PER_METRE);
    }
  }

  /**
   * @param dismissed whether a person said that the map stays as it is there
   */
  public record Sighting(Instant first, Instant last, Set<String> robots, boolean dismissed) {
    public Sighting {
      robots = Set.copyOf(robots);
    }
  }

  /**
   * Cells that touch, to be drawn as a wall.
   *
   * @param id of the first of its cells
   * @param cells their middles, metres, map frame
   * @param robots that have seen it, by name
   */
  public record Offer(
      String id, List<Vec2> cells, List<String> robots, Instant since, Instant last) {
    public Offer {
      cells = List.copyOf(cells);
      robots = List.copyOf(robots);
    }

    /** Its middle. */
    public Vec2 centre() {
      return cells.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / cells.size());
    }
  }

  /**
   * @param stored as {@link #takeChanged} gave it
   */
  public SeenPlaces(Map<Spot, Sighting> stored) {
    sightings.putAll(stored);
  }

  /** Takes in what is seen on the floor, and where robots stand. */
  public synchronized void observe(
      FloorMap floor, FloorView view, List<RobotView> robots, Instant now) {
    OccupancyGrid grid = floor.grid();
    Set<Spot> seen = new HashSet<>();
    for (SeenObstacle obstacle : view.seen()) {
      if (!obstacle.isDoubted()) {
        obstacle.cells().cells().stream()
            .forEach(index -> seen.add(see(Spot.of(floor, grid.cell(index)), obstacle)));
      }
    }
    changed |= !seen.isEmpty();
    changed |=
        sightings
            .entrySet()
            .removeIf(
                entry ->
                    entry.getKey().floor().equals(floor.name())
                        && !seen.contains(entry.getKey())
                        && isOver(entry.getKey(), entry.getValue(), grid, robots, now));
  }

  private Spot see(Spot spot, SeenObstacle obstacle) {
    Sighting before = sightings.get(spot);
    Set<String> robots = new HashSet<>(obstacle.robots());
    if (before != null) {
      robots.addAll(before.robots());
    }
    sightings.put(
        spot,
        new Sighting(
            before == null ? obstacle.since() : before.first(),
            obstacle.last(),
            robots,
            before != null && before.dismissed()));
    return spot;
  }

  private static boolean isOver(
      Spot spot, Sighting sighting, OccupancyGrid grid, List<RobotView> robots, Instant now) {
    Vec2 there = spot.position();
    return !sighting.last().plus(FORGET_AFTER).isAfter(now)
        || !grid.isFree(there)
        || robots.stream().anyMatch(robot -> isStandingOn(robot, spot.floor(), there));
  }

  private static boolean isStandingOn(RobotView robot, String floor, Vec2 there) {
    Pose pose = robot.telemetry().pose();
    return pose != null
        && robot.floor().equals(floor)
        && robot.state() != RobotState.LOST
        && pose.position().distanceTo(there) < robot.capabilities().footprint() / 2;
  }

  /** What many have seen for long on that floor, unless somebody has dismissed it. */
  public synchronized List<Offer> offers(FloorMap floor) {
    return groups(floor).stream()
        .filter(
            group -> group.values().stream().noneMatch(Sighting::dismissed) && isOfferDue(group))
        .map(SeenPlaces::offer)
        .sorted(Comparator.comparing(Offer::since).thenComparing(Offer::id))
        .toList();
  }

  public Optional<Offer> offer(FloorMap floor, String id) {
    return offers(floor).stream().filter(offer -> offer.id().equals(id)).findFirst();
  }

  /** It is offered no more, until it is gone and comes again. */
  public synchronized void dismiss(FloorMap floor, Offer offer) {
    for (Vec2 cell : offer.cells()) {
      sightings.computeIfPresent(
          Spot.of(floor, floor.grid().cellAt(cell)),
          (_, before) -> new Sighting(before.first(), before.last(), before.robots(), true));
    }
    changed = true;
  }

  /** Nothing was ever seen on a floor of that name. */
  synchronized void forget(String floor) {
    changed |= sightings.keySet().removeIf(spot -> spot.floor().equals(floor));
  }

  /** All that is known, if it has changed since this was asked last. */
  synchronized Optional<Map<Spot, Sighting>> takeChanged() {
    boolean isNew = changed;
    changed = false;
    return isNew ? Optional.of(Map.copyOf(sightings)) : Optional.empty();
  }

  /** What was taken could not be stored. */
  synchronized void setChanged() {
    changed = true;
  }

  private List<Map<Spot, Sighting>> groups(FloorMap floor) {
    Map<Cell, Spot> left = new HashMap<>();
    for (Spot spot : sightings.keySet()) {
      if (spot.floor().equals(floor.name()) && floor.grid().isFree(spot.position())) {
        left.put(floor.grid().cellAt(spot.position()), spot);
      }
    }
    List<Map<Spot, Sighting>> groups = new ArrayList<>();
    while (!left.isEmpty()) {
      groups.add(takeGroup(left));
    }
    return groups;
  }

  private Map<Spot, Sighting> takeGroup(Map<Cell, Spot> left) {
    Map<Spot, Sighting> group = new TreeMap<>(Comparator.comparing(Spot::x).thenComparing(Spot::y));
    Deque<Cell> next = new ArrayDeque<>(List.of(left.keySet().iterator().next()));
    while (!next.isEmpty()) {
      Cell cell = next.pop();
      Spot spot = left.remove(cell);
      if (spot != null) {
        group.put(spot, sightings.get(spot));
        for (int dx = -1; dx <= 1; dx++) {
          for (int dy = -1; dy <= 1; dy++) {
            next.push(new Cell(cell.column() + dx, cell.row() + dy));
          }
        }
      }
    }
    return group;
  }

  private static boolean isOfferDue(Map<Spot, Sighting> group) {
    Offer offer = offer(group);
    return offer.robots().size() >= LEAST_ROBOTS
        && Duration.between(offer.since(), offer.last()).compareTo(OFFER_AFTER) >= 0;
  }

  private static Offer offer(Map<Spot, Sighting> group) {
    Spot first = group.keySet().iterator().next();
    Set<String> robots = new TreeSet<>();
    group.values().forEach(sighting -> robots.addAll(sighting.robots()));
    return new Offer(
        first.x() + "_" + first.y(),
        group.keySet().stream().map(Spot::position).toList(),
        List.copyOf(robots),
        group.values().stream().map(Sighting::first).min(Instant::compareTo).orElseThrow(),
        group.values().stream().map(Sighting::last).max(Instant::compareTo).orElseThrow());
  }
}
