package org.toqa.fleet;

import java.util.Optional;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;

/** Whether a floor has room for robots that carry a load together, all the way. */
final class TeamRoom {
  private final FormationPlaces places;

  TeamRoom(OccupancyGrid grid) {
    this.places = new FormationPlaces(grid);
  }

  /** Why so many robots cannot carry it, a sentence; empty if they can, or one does. */
  Optional<String> objection(Mission mission, int robots) {
    boolean isPossible =
        robots < 2
            || places
                .round(
                    mission.object().position(),
                    mission.task().goal().position(),
                    robots,
                    mission.task().size(),
                    FloorRobot.UNKNOWN_FOOTPRINT / 2)
                .isPresent();
    return isPossible
        ? Optional.empty()
        : Optional.of(
            "It needs %d robots that carry it together, and there is no room for them round it at %s or no way for them to %s."
                .formatted(robots, mission.object().text(), mission.task().goal().text()));
  }
}
