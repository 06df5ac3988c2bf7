package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabResult;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;

/** What every database must do for runs; here H2, in {@code MySqlLabRunStoreTest} MySQL. */
class LabRunStoreTest extends DatabaseTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00.123Z");
  private static final LabOrder ORDER =
      new LabOrder("csm-static", -9_007_199_254_740_991L, 3, Map.of("lag", 0.05, "delay", 0.1));

  private JdbiLabRunStore store;

  @BeforeEach
  void openStore() {
    store = new JdbiLabRunStore(database.jdbi());
  }

  @Test
  void aRunComesBackWithEveryField() {
    LabRun added = store.add(ORDER, "Zoë", AT);
    assertEquals(Optional.of(added), store.run(added.id()));
    assertTrue(store.begin(added.id(), AT.plusSeconds(1)));
    assertTrue(store.end(added.id(), LabRunState.FAILED, "x".repeat(2000), AT.plusSeconds(2)));

    assertEquals(
        new LabRun(
            added.id(),
            ORDER,
            "Zoë",
            AT,
            AT.plusSeconds(1),
            AT.plusSeconds(2),
            LabRunState.FAILED,
            "x".repeat(1000)),
        store.runs().getFirst());
  }

  @Test
  void whatARunGaveComesBackAndGoesWithIt() {
    KeptDrawing moving =
        new KeptDrawing("floor-1", "Floor é", "<svg/>".repeat(200_000), "{\"bodies\":[]}");
    KeptDrawing still = new KeptDrawing("cost", "Cost", "<svg/>", null);
    long id = store.add(ORDER, "Max", AT).id();
    store.begin(id, AT);
    store.complete(id, new LabResult("{\"figures\":[]}", List.of(moving, still)), AT);

    assertEquals(Optional.of("{\"figures\":[]}"), store.report(id));
    assertEquals(
        List.of(
            new KeptDrawing.Entry("floor-1", "Floor é", true),
            new KeptDrawing.Entry("cost", "Cost", false)),
        store.drawings(id));
    assertEquals(Optional.of(moving), store.drawing(id, "floor-1"));
    assertEquals(Optional.of(still), store.drawing(id, "cost"));
    assertEquals(Optional.empty(), store.drawing(id, "other"));

    assertTrue(store.delete(id));
    assertEquals(List.of(), store.runs());
    assertEquals(List.of(), store.drawings(id));
  }

  @Test
  void aRunThatIsOverStaysSoAndOneThatIsNotIsNotDeleted() {
    long id = store.add(ORDER, "Max", AT).id();
    assertFalse(store.delete(id));
    assertTrue(store.begin(id, AT));
    assertFalse(store.begin(id, AT), "it runs already");
    assertFalse(store.delete(id));
    assertTrue(store.end(id, LabRunState.STOPPED, null, AT));
    assertFalse(store.end(id, LabRunState.FAILED, "late", AT));
    store.complete(id, new LabResult("{}", List.of()), AT);

    assertEquals(LabRunState.STOPPED, store.runs().getFirst().state());
    assertEquals(Optional.empty(), store.report(id));
  }

  @Test
  void whatRanIsBrokenOffAndWhatWaitsWaits() {
    long ran = store.add(ORDER, "Max", AT).id();
    long waits = store.add(ORDER, "Max", AT).id();
    store.begin(ran, AT);
    store.breakOff(AT.plusSeconds(9));

    assertEquals(LabRunState.BROKEN_OFF, store.run(ran).orElseThrow().state());
    assertEquals(AT.plusSeconds(9), store.run(ran).orElseThrow().endedAt());
    assertEquals(LabRunState.QUEUED, store.run(waits).orElseThrow().state());
  }
}
