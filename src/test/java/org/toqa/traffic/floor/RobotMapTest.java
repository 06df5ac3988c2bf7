package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;

class RobotMapTest {
  private final RobotMap<Integer> map = new RobotMap<>();

  /** Whoever keeps them sees who comes and goes, in the order of names. */
  @Test
  void valuesAreThoseThatAreThereNow() {
    Collection<Integer> values = map.values();
    map.put("r2", 2);
    map.put("r10", 10);
    assertThere(values, 10, 2);
    map.put("r1", 1);
    map.put("r2", 20);
    assertThere(values, 1, 10, 20);
    map.remove("r10");
    assertThere(values, 1, 20);
  }

  private static void assertThere(Collection<Integer> values, Integer... expected) {
    List<Integer> wanted = List.of(expected);
    assertEquals(wanted, new ArrayList<>(values));
    assertEquals(wanted, values.stream().toList());
    List<Integer> seen = new ArrayList<>();
    values.forEach(seen::add);
    assertEquals(wanted, seen);
    assertEquals(wanted.size(), values.size());
  }

  /** Who takes one away while he goes through them still sees those that were there. */
  @Test
  void oneMayBeTakenAwayOnTheWay() {
    map.put("a", 1);
    map.put("b", 2);
    List<Integer> seen = new ArrayList<>();
    for (Integer value : map.values()) {
      map.remove("b");
      seen.add(value);
    }
    assertEquals(List.of(1, 2), seen);
    assertThere(map.values(), 1);
  }
}
