package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class TeamSizeTest {
  private static Candidate robot(String name, double maxLoad, boolean canBeInTeam) {
    return new Candidate(
        name,
        maxLoad,
        0.255,
        0.25,
        true,
        Vec2.ZERO,
        Vec2.ZERO,
        1.0,
        Availability.FREE,
        null,
        canBeInTeam);
  }

  @Test
  void whoCannotBeInATeamCarriesOnlyAlone() {
    List<Candidate> robots =
        List.of(robot("r1", 5, true), robot("r2", 5, true), robot("h1", 6, false));

    assertEquals(Optional.of(1), TeamSize.smallest(6, robots)); // h1
    assertEquals(Optional.of(2), TeamSize.smallest(10, robots)); // r1 and r2
    assertEquals(Optional.empty(), TeamSize.smallest(11, robots)); // h1 and r1 would do
  }
}
