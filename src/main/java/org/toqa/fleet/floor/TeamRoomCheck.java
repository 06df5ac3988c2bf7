package org.toqa.fleet.floor;

import java.util.Optional;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whether a floor has room for robots that carry a load together, along the whole path. */
public final class TeamRoomCheck {
  private final FormationPlacement places;

  public TeamRoomCheck(OccupancyGrid grid) {
    this.places = new FormationPlacement(grid);
  }

  /**
   * Why so many robots cannot carry it; empty if they can, or one does.
   *
   * @param diameter of the largest of them, metres
   */
  public Optional<Sentence> objection(Mission mission, int robots, double diameter) {
    boolean isPossible =
        robots < 2
            || places
                .find(
                    mission.object().position(),
                    mission.task().goal().position(),
                    robots,
                    mission.task().size(),
                    diameter / 2)
                .isPresent();
    return isPossible ? Optional.empty() : Optional.of(objection(mission, robots));
  }

  /** Of a mission that so many robots have no room for. */
  static Sentence objection(Mission mission, int robots) {
    return Phrase.NO_ROOM_FOR_TEAM.with(
        robots, mission.object().sentence(), mission.task().goal().sentence());
  }
}
