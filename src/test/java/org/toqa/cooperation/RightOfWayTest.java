package org.toqa.cooperation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.cooperation.RightOfWay.Place;
import org.toqa.geometry.Vec2;

class RightOfWayTest {
  private static Place at(String robot, double x, boolean isDriving) {
    return new Place(robot, new Vec2(x, 0), isDriving, false, null);
  }

  @Test
  void twoThatAreTooCloseStandAndOnePasses() {
    RightOfWay next = RightOfWay.CLEAR.next(List.of(at("R1", 0, true), at("R2", 4, true)), 5);

    assertEquals("R1", next.passing());
    assertTrue(next.mayDrive("R1"));
    assertFalse(next.mayDrive("R2"));
    RightOfWay arrived = next.next(List.of(at("R1", 0, false), at("R2", 4, true)), 5);
    assertEquals("R2", arrived.passing());
    assertEquals(RightOfWay.CLEAR, next.next(List.of(at("R1", 0, true), at("R2", 5.1, true)), 5));
  }

  @Test
  void whoCarriesGoesFirst() {
    Place carrier = new Place("R2", new Vec2(4, 0), true, true, null);

    assertEquals("R2", RightOfWay.CLEAR.next(List.of(at("R1", 0, true), carrier), 5).passing());
  }

  @Test
  void twoThatCarryTogetherAreNoDangerToEachOtherAndStandTogether() {
    Place first = new Place("R1", new Vec2(0, 0), true, true, "R2");
    Place second = new Place("R2", new Vec2(4, 0), true, true, "R1");

    assertEquals(RightOfWay.CLEAR, RightOfWay.CLEAR.next(List.of(first, second), 5));
    RightOfWay next = RightOfWay.CLEAR.next(List.of(first, second, at("R3", 8, true)), 5);
    assertFalse(next.mayDrive("R3"));
    assertTrue(next.standing().contains("R1"), "nor may the one that is farther away");
  }

  @Test
  void whenNoneHasAPathNobodyPassesUntilOneMakesRoom() {
    List<Place> places = List.of(at("R1", 0, true), at("R2", 4, true));
    RightOfWay first = RightOfWay.CLEAR.next(places, 5).blocked().next(places, 5);
    assertEquals("R2", first.passing());

    RightOfWay none = first.blocked().next(places, 5);

    assertNull(none.passing());
    assertEquals("R2", none.makesRoom("R2").passing());
  }
}
