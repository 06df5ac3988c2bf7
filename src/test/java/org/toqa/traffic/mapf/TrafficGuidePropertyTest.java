package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;

class TrafficGuidePropertyTest {

  @Provide
  Arbitrary<Floor> crowded() {
    return RandomFloors.strewn(8, 0.2, 24);
  }

  @Property(tries = 200)
  void theFirstIsGuidedByTheShortestPath(@ForAll("crowded") Floor floor) {
    RoadGraph roads = new RoadGraph(floor.grid());
    int start = roads.vertex(floor.starts().getFirst());
    int goal = roads.vertex(floor.goals().getFirst());

    char[] toGo = new TrafficGuide(roads).announce(start, goal);

    char[] steps = DistanceTables.of(roads, new int[] {goal}, Deadline.none())[0];
    if (roads.canReach(start, goal)) {
      assertEquals(TrafficGuide.STEP * steps[start], toGo[start]);
    }
  }

  @Property(tries = 200)
  void trafficMakesNoPathCheaper(@ForAll("crowded") Floor floor) {
    RoadGraph roads = new RoadGraph(floor.grid());
    TrafficGuide guide = new TrafficGuide(roads);
    for (int robot = 0; robot < floor.starts().size(); robot++) {
      int goal = roads.vertex(floor.goals().get(robot));
      char[] toGo = guide.announce(roads.vertex(floor.starts().get(robot)), goal);
      char[] steps = DistanceTables.of(roads, new int[] {goal}, Deadline.none())[0];
      for (int v = 0; v < steps.length; v++) {
        assertTrue(
            steps[v] == DistanceTables.UNREACHABLE || toGo[v] >= TrafficGuide.STEP * steps[v]);
      }
    }
  }
}
