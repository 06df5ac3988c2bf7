package org.toqa.fleet.floor;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.toqa.formation.GroupMobility;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Bottleneck;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.traffic.floor.FormationPaths;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whether a floor has room for robots that carry a load together, along the whole path. */
public final class TeamRoomCheck {
  private final OccupancyGrid grid;
  private final FormationPlacement places;

  public TeamRoomCheck(OccupancyGrid grid, Margins margins) {
    this.grid = grid;
    this.places = new FormationPlacement(grid, margins);
  }

  /**
   * Why so many robots cannot carry it, and where; empty if they can, or one does.
   *
   * @param diameter of the largest of them, metres
   * @param mobility how they can be led
   */
  public Optional<Sentence> objection(
      Mission mission, int robots, double diameter, GroupMobility mobility) {
    if (robots < 2) {
      return Optional.empty();
    }
    Vec2 object = mission.object().position();
    LoadSize size = Objects.requireNonNullElse(mission.task().size(), LoadSize.DEFAULT);
    List<Formation> around = places.around(object, robots, size, diameter / 2, mobility);
    List<TaskPlace> stops = mission.placesFromObject();
    List<FormationPaths> legs = places.legs(stops.stream().map(TaskPlace::position).toList());
    if (FormationPlacement.firstWithPath(around, legs).isPresent()) {
      return Optional.empty();
    }
    if (around.isEmpty()) {
      return Optional.of(Phrase.NO_ROOM_AROUND_LOAD.with(robots, mission.object().sentence()));
    }
    int leg = legs.size() == 1 ? 0 : firstWithoutPath(around, legs);
    TaskPlace from = leg == 0 ? mission.object() : stops.get(leg - 1);
    return Optional.of(reason(from, stops.get(leg), robots, around, legs.get(leg)));
  }

  /** The number of the leg to which those that come farthest come. */
  private static int firstWithoutPath(List<Formation> around, List<FormationPaths> legs) {
    return around.stream()
        .mapToInt(formation -> FormationPlacement.passedLegs(formation, legs, true))
        .max()
        .orElse(0);
  }

  private Sentence reason(
      TaskPlace from, TaskPlace goal, int robots, List<Formation> around, FormationPaths paths) {
    if (around.stream().noneMatch(f -> paths.hasRoomAtGoal(f.group()))) {
      return Phrase.NO_ROOM_AT_GOAL.with(robots, goal.sentence());
    }
    double width =
        around.stream()
            .map(f -> paths.passageWidth(f.group()))
            .min(Comparator.naturalOrder())
            .orElseThrow();
    return Bottleneck.between(grid, from.position(), goal.position(), width)
        .map(
            passage ->
                Phrase.PASSAGE_TOO_NARROW.with(
                    robots, Sentence.of(passage.place()), passage.width(), width))
        .orElseGet(
            () ->
                Phrase.NO_ROOM_TO_TURN.with(
                    robots, goal.sentence(), Sentence.of(paths.nearest().orElse(from.position()))));
  }

  /** Of a mission that so many robots have no room for. */
  static Sentence objection(Mission mission, int robots) {
    return Phrase.NO_ROOM_FOR_TEAM.with(
        robots, mission.object().sentence(), mission.task().goal().sentence());
  }
}
