package org.toqa.traffic;

import java.util.List;

/**
 * The next steps of all robots, driven together without collision; after them every robot can stay
 * where it is then.
 *
 * @param itineraries in the order of the scene's robots
 */
public record TrafficPlan(List<Itinerary> itineraries) {
  public TrafficPlan {
    itineraries = List.copyOf(itineraries);
  }

  public Itinerary of(int robot) {
    return itineraries.get(robot);
  }
}
