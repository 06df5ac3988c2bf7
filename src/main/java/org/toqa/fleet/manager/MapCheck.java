package org.toqa.fleet.manager;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.motion.FreeZone;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What speaks against a drawing of a floor, by itself and by what is on the floor now.
 *
 * @param before the grid that is in force
 * @param elsewhere the site's other floors by the names of their stations
 * @param robots of the floor
 * @param tasks that have not ended
 * @param schedules all of the floor
 */
record MapCheck(
    OccupancyGrid before,
    Map<String, String> elsewhere,
    List<RobotView> robots,
    List<TransportTask> tasks,
    List<LeftLoad> loads,
    List<Schedule> schedules) {

  /** Robots report where they are a little off: so much of one may lie in a wall, metres. */
  private static final double POSE_TOLERANCE = 0.02;

  List<MapProblem> problems(FloorDrawing drawing) {
    OccupancyGrid grid = drawing.drivable();
    List<MapProblem> problems = new ArrayList<>();
    addPlaces(drawing, grid, problems);
    addTakenNames(drawing, problems);
    robots.forEach(robot -> addRobot(robot, drawing, grid, problems));
    tasks.forEach(task -> addTask(task, drawing, grid, problems));
    loads.forEach(load -> addLoad(load, grid, problems));
    schedules.forEach(schedule -> addSchedule(schedule, drawing, grid, problems));
    drawing.freeZones().forEach(zone -> addFreeZone(zone, drawing, problems));
    addHints(drawing, problems);
    return problems;
  }

  private static MapProblem blocking(Sentence text, @Nullable Vec2 where) {
    return new MapProblem(true, text, where);
  }

  private static void addPlaces(
      FloorDrawing drawing, OccupancyGrid grid, List<MapProblem> problems) {
    Reach reach = Reach.of(grid, drawing.places().toList());
    if (reach.isEmpty()) {
      problems.add(blocking(Phrase.MAP_HAS_NO_ROOM.with(), null));
      return;
    }
    drawing
        .places()
        .forEach(
            place ->
                objection(grid, place.name(), place.position())
                    .or(() -> reach.objection(place))
                    .ifPresent(text -> problems.add(blocking(text, place.position()))));
  }

  private void addTakenNames(FloorDrawing drawing, List<MapProblem> problems) {
    for (Place station : drawing.stations()) {
      takenName(station, elsewhere)
          .ifPresent(text -> problems.add(blocking(text, station.position())));
    }
  }

  /** What is said of a station whose name another floor of the site has. */
  static Optional<Sentence> takenName(Place station, Map<String, String> elsewhere) {
    return Optional.ofNullable(elsewhere.get(station.name()))
        .map(floor -> Phrase.STATION_NAME_TAKEN.with(station.name(), floor));
  }

  private static Optional<Sentence> objection(OccupancyGrid grid, String name, Vec2 position) {
    return PlaceCheck.objection(grid, Phrase.PLACE, new TaskPlace(position, name));
  }

  private void addRobot(
      RobotView robot, FloorDrawing drawing, OccupancyGrid grid, List<MapProblem> problems) {
    Disc body = new Disc(robot.capabilities().footprint() / 2 - POSE_TOLERANCE);
    if (robot.telemetry().pose() != null) {
      Vec2 where = robot.telemetry().pose().position();
      if (!body.isFreeAt(grid, where) && body.isFreeAt(before, where)) {
        problems.add(blocking(Phrase.ROBOT_IN_NEW_WALL.with(robot.name()), where));
      }
    }
    String parking = robot.record().parking();
    if (parking != null && drawing.parking().stream().noneMatch(p -> p.name().equals(parking))) {
      problems.add(blocking(Phrase.PARKING_GONE.with(parking, robot.name()), null));
    }
    cutPath(robot, body, grid)
        .ifPresent(
            where ->
                problems.add(new MapProblem(false, Phrase.PATH_CUT.with(robot.name()), where)));
  }

  /** Where a robot's path meets a new wall. */
  private Optional<Vec2> cutPath(RobotView robot, Disc body, OccupancyGrid grid) {
    List<Vec2> path = robot.pathPoints();
    for (int i = 1; i < path.size(); i++) {
      Vec2 from = path.get(i - 1);
      Vec2 to = path.get(i);
      boolean isCut =
          body.cellsAlong(grid, from, to).stream()
              .filter(cell -> !grid.isFree(cell))
              .anyMatch(cell -> before.isFree(before.cellAt(grid.centre(cell))));
      if (isCut) {
        return Optional.of(to);
      }
    }
    return Optional.empty();
  }

  private static void addTask(
      TransportTask task, FloorDrawing drawing, OccupancyGrid grid, List<MapProblem> problems) {
    task.stops().stream()
        .map(Stop::charge)
        .filter(Objects::nonNull)
        .map(Stop.Charge::charger)
        .filter(Objects::nonNull)
        .filter(name -> drawing.charging().stream().noneMatch(c -> c.name().equals(name)))
        .forEach(
            name -> problems.add(blocking(Phrase.TASK_CHARGER_GONE.with(task.id(), name), null)));
    task.placesFrom(0).stream()
        .filter(place -> PlaceCheck.objection(grid, Phrase.PLACE, place).isPresent())
        .findFirst()
        .ifPresent(
            place ->
                problems.add(
                    blocking(
                        Phrase.TASK_PLACE_GONE.with(task.id(), place.sentence()),
                        place.position())));
  }

  private static void addLoad(LeftLoad load, OccupancyGrid grid, List<MapProblem> problems) {
    if (!grid.isFree(load.where())) {
      problems.add(blocking(Phrase.LOAD_IN_NEW_WALL.with(load.name(), load.task()), load.where()));
    }
  }

  private static void addSchedule(
      Schedule schedule, FloorDrawing drawing, OccupancyGrid grid, List<MapProblem> problems) {
    for (Where where : schedule.order().places()) {
      switch (where) {
        case Where.Station(String name) -> {
          if (drawing.stations().stream().noneMatch(s -> s.name().equals(name))) {
            problems.add(
                blocking(Phrase.SCHEDULED_STATION_GONE.with(schedule.order().name(), name), null));
          }
        }
        case Where.Charger(String name) -> {
          if (name != null && drawing.charging().stream().noneMatch(c -> c.name().equals(name))) {
            problems.add(
                blocking(Phrase.SCHEDULED_CHARGER_GONE.with(schedule.order().name(), name), null));
          }
        }
        case Where.Point(Vec2 position) -> {
          TaskPlace place = new TaskPlace(position, null);
          if (PlaceCheck.objection(grid, Phrase.PLACE, place).isPresent()) {
            problems.add(
                blocking(
                    Phrase.SCHEDULED_PLACE_GONE.with(schedule.order().name(), place.sentence()),
                    position));
          }
        }
      }
    }
  }

  /** Why robots would follow their paths through a free zone as if there were none. */
  private void addFreeZone(Area zone, FloorDrawing drawing, List<MapProblem> problems) {
    Vec2 middle = zone.low().plus(new Vec2(zone.width() / 2, zone.height() / 2));
    if (drawing.oneWay().stream().anyMatch(way -> way.area().overlaps(zone))) {
      problems.add(new MapProblem(false, Phrase.FREE_ZONE_ONE_WAY.with(middle.toString()), middle));
    }
    for (RobotView robot : robots) {
      double needed = robot.capabilities().footprint() + FreeZone.AIR;
      if (robot.capabilities().findsOwnWay() && Math.min(zone.width(), zone.height()) < needed) {
        String metres = String.format(Locale.ROOT, "%.2f", needed);
        problems.add(
            new MapProblem(
                false,
                Phrase.FREE_ZONE_NARROW.with(middle.toString(), robot.name(), metres),
                middle));
      }
    }
  }

  private static void addHints(FloorDrawing drawing, List<MapProblem> problems) {
    hint(drawing.stations(), Phrase.NO_STATIONS_DRAWN, problems);
    hint(drawing.parking(), Phrase.NO_PARKING_DRAWN, problems);
    hint(drawing.charging(), Phrase.NO_CHARGING_DRAWN, problems);
  }

  private static void hint(List<Place> places, Phrase text, List<MapProblem> problems) {
    if (places.isEmpty()) {
      problems.add(new MapProblem(false, text.with(), null));
    }
  }
}
