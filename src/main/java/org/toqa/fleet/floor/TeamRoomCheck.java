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
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.traffic.floor.FormationPaths;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whether a floor has room for robots that carry a load together, along the whole path. */
public final class TeamRoomCheck {
  private final OccupancyGrid grid;
  private final Margins margins;
  private final FormationPlacement places;

  public TeamRoomCheck(OccupancyGrid grid, Margins margins) {
    this.grid = grid;
    this.margins = margins;
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
    Vec2 goal = mission.task().goal().position();
    LoadSize size = Objects.requireNonNullElse(mission.task().size(), LoadSize.DEFAULT);
    List<Formation> around = places.around(object, robots, size, diameter / 2, mobility);
    FormationPaths paths = new FormationPaths(grid, margins, goal);
    if (FormationPlacement.firstWithPath(around, paths).isPresent()) {
      return Optional.empty();
    }
    return Optional.of(reason(mission, robots, around, paths));
  }

  private Sentence reason(
      Mission mission, int robots, List<Formation> around, FormationPaths paths) {
    Vec2 object = mission.object().position();
    Vec2 goal = mission.task().goal().position();
    if (around.isEmpty()) {
      return Phrase.NO_ROOM_AROUND_LOAD.with(robots, mission.object().sentence());
    }
    if (around.stream().noneMatch(f -> paths.hasRoomAtGoal(f.group()))) {
      return Phrase.NO_ROOM_AT_GOAL.with(robots, mission.task().goal().sentence());
    }
    double width =
        around.stream()
            .map(f -> paths.passageWidth(f.group()))
            .min(Comparator.naturalOrder())
            .orElseThrow();
    return Bottleneck.between(grid, object, goal, width)
        .map(
            passage ->
                Phrase.PASSAGE_TOO_NARROW.with(
                    robots, Sentence.of(passage.place()), passage.width(), width))
        .orElseGet(
            () ->
                Phrase.NO_ROOM_TO_TURN.with(
                    robots,
                    mission.task().goal().sentence(),
                    Sentence.of(paths.nearest().orElse(object))));
  }

  /** Of a mission that so many robots have no room for. */
  static Sentence objection(Mission mission, int robots) {
    return Phrase.NO_ROOM_FOR_TEAM.with(
        robots, mission.object().sentence(), mission.task().goal().sentence());
  }
}
