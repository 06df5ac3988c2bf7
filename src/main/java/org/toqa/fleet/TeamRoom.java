package org.toqa.fleet;

import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;

/** Whether robots find places round a load where it is picked up, and where it is set down. */
final class TeamRoom {
  private final FormationPlaces places;

  TeamRoom(OccupancyGrid grid) {
    this.places = new FormationPlaces(grid);
  }

  /** Why so many robots cannot carry it, a sentence; empty if they can, or one does. */
  Optional<String> objection(Mission mission, int robots) {
    if (robots < 2) {
      return Optional.empty();
    }
    return Stream.of(mission.object(), mission.task().goal())
        .filter(place -> !hasRoom(mission, place, robots))
        .findFirst()
        .map(
            place ->
                "It needs %d robots that carry it together, and round it at %s is no room for them."
                    .formatted(robots, place.text()));
  }

  private boolean hasRoom(Mission mission, TaskPlace place, int robots) {
    return places
        .round(
            place.position(), robots, mission.task().size(), FloorRobot.UNKNOWN_FOOTPRINT / 2)
        .isPresent();
  }
}
