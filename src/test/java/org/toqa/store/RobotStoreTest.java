package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.Hold;
import org.toqa.fleet.LastPlace;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.geometry.Pose;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.Phase;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.persistence.StoreException;
import org.toqa.telemetry.ReadingLimits;
import org.toqa.wording.Sentence;

/** What every database must do for robots; here H2, in {@code MySqlRobotStoreTest} MySQL. */
class RobotStoreTest extends FleetDatabaseTest {
  @Test
  void robotsComeBackAsTheyWereStored() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    RobotRecord moved = RobotRecord.direct("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null);
    store.saveRobot(moved);
    assertEquals(List.of(moved, R2), store.robots());

    RobotRecord behind = moved.withChange(new RobotChange("10.0.0.7", 7275, 5, "P1", "dock"));
    assertTrue(store.updateRobot(moved, behind, List.of()));
    assertEquals(List.of(behind, R2), store.robots());
    assertFalse(store.updateRobot(moved, R1, List.of()), "it is reached by another gateway now");
  }

  @Test
  void passwordAndLimitsOfReadingsEndWithTheirRobot() {
    store.saveRobot(R1);
    JdbiTelemetryStore telemetry = new JdbiTelemetryStore(database.jdbi(), InstantSource.system());
    assertEquals(Optional.empty(), telemetry.passwordHash("r1"));
    telemetry.setPasswordHash("r1", "a".repeat(64), "Max");
    telemetry.setPasswordHash("r1", "b".repeat(64), "Max");
    assertEquals(Optional.of("b".repeat(64)), telemetry.passwordHash("r1"));
    ReadingLimits low = new ReadingLimits("r1", "range", 0.25, null);
    ReadingLimits both = new ReadingLimits("r1", "heat", -3.5, 60.0);
    telemetry.setLimits(new ReadingLimits("r1", "range", 1.0, 2.0));
    telemetry.setLimits(low);
    telemetry.setLimits(both);
    assertEquals(List.of(both, low), telemetry.limits());
    telemetry.setLimits(new ReadingLimits("r1", "heat", null, null));
    assertEquals(List.of(low), telemetry.limits());

    store.removeRobot("r1", List.of());

    assertEquals(Optional.empty(), telemetry.passwordHash("r1"));
    assertEquals(List.of(), telemetry.limits());
  }

  @Test
  void aRobotStaysOutOfServiceWhenItsAddressChanges() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    assertEquals(Set.of(), robots(StoredRobot::outOfService));

    store.saveService("r1", false, List.of());
    store.saveService("r2", false, List.of());
    store.saveService("r2", true, List.of());
    store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null));

    assertEquals(Set.of("r1"), robots(StoredRobot::outOfService));
    assertThrows(StoreException.class, () -> store.saveService("nobody", false, List.of()));
  }

  @Test
  void aRobotIsChangedOnlyFromWhatItWas() {
    store.saveRobot(R1);
    RobotRecord weaker = R1.withChange(new RobotChange(R1.host(), R1.port(), 2, null));
    assertTrue(store.updateRobot(R1, weaker, List.of()));
    Fingerprint shown = new Fingerprint("a".repeat(64));
    EventRecord event =
        new EventRecord(
            Instant.EPOCH, EventKind.ROBOT_PAIRED, null, "r1", "boss", Sentence.verbatim("paired"));

    assertFalse(store.updateRobot(R1, R1.withFingerprint(shown), List.of(event)));

    assertEquals(List.of(weaker), store.robots());
    assertEquals(0, events());
    assertTrue(store.updateRobot(weaker, weaker.withFingerprint(shown), List.of(event)));
    assertEquals(List.of(weaker.withFingerprint(shown)), store.robots());
    assertEquals(1, events());
    assertTrue(store.updateRobot(weaker.withFingerprint(shown), R1, List.of()));
    assertEquals(List.of(R1), store.robots());
    store.removeRobot("r1", List.of());
    assertFalse(store.updateRobot(R1, weaker, List.of()));
    assertEquals(List.of(), store.robots());
  }

  private int events() {
    return database
        .jdbi()
        .withHandle(h -> h.createQuery("select count(*) from events").mapTo(Integer.class).one());
  }

  @Test
  void whereARobotStoodComesBackUntilItDrivesOrIsSaidToBeGone() {
    store.saveRobot(R1);
    assertNull(place());

    Pose pose = new Pose(1.5, 2.5, 0.25);
    store.savePlace("r1", pose, 0.3, 0);
    assertEquals(LastPlace.standing(pose, 0.3), place());

    Trajectory way = new Trajectory(pose, List.of(new Segment(0.25, 0, 4)));
    store.saveDrive("r1", new StoredDrive(7, null, Phase.NONE, way));
    assertEquals(new LastPlace(0.3, way), place());

    Segment turn = new Segment(0, 0.5, 1);
    store.saveDriveEnd("r1", 7, 1, List.of(turn));
    Trajectory longer = new Trajectory(pose, List.of(way.segments().getFirst(), turn));
    assertEquals(new LastPlace(0.3, longer), place());

    PassingRoom room = new PassingRoom(0, 2, 0.3, 0);
    store.saveRoom("r1", 7, room);
    store.saveRoom("r1", 6, null); // of a drive before
    assertEquals(new LastPlace(0.3, longer, room), place());
    store.saveRoom("r1", 7, null);
    assertEquals(new LastPlace(0.3, longer), place());
    FreeZone zone =
        new FreeZone(1, 2, 3, 2.5, 0, List.of()); // what only its robot needs is not kept
    PassingRoom free = new PassingRoom(0, 2, 0, 0, zone);
    store.saveRoom("r1", 7, free);
    assertEquals(new LastPlace(0.3, longer, free), place());
    store.saveRoom("r1", 7, room);
    assertEquals(new LastPlace(0.3, longer, room), place());
    store.saveDrive("r1", new StoredDrive(7, null, Phase.NONE, longer));
    assertEquals(new LastPlace(0.3, longer), place());

    store.savePlace("r1", way.end(), 0.3, 7);
    assertEquals(LastPlace.standing(way.end(), 0.3), place());

    store.saveGone("r1", List.of());
    assertNull(place());
    assertEquals(Set.of("r1"), robots(StoredRobot::outOfService));
  }

  @Test
  void aRobotThatWasCarriedStandsWhereAPersonSaidUntilItKnowsThat() {
    store.saveRobot(R1);
    store.saveHold("r1", true, List.of());
    assertEquals(Set.of(), robots(StoredRobot::carried));
    Pose pose = new Pose(1.5, 2.5, 0.25);

    store.moveRobot("r1", new RobotMove("attic", pose), 0.3, List.of());

    assertEquals(List.of(R1.movedTo("attic")), store.robots());
    assertEquals(LastPlace.standing(pose, 0.3), place());
    assertEquals(Set.of("r1"), robots(StoredRobot::held));
    assertEquals(Set.of("r1"), robots(StoredRobot::carried));
    store.saveLocated("r1");
    assertEquals(Set.of(), robots(StoredRobot::carried));
    store.moveRobot("r1", new RobotMove("hall", pose), 0.3, List.of());
    store.removeRobot("r1", List.of());
    store.saveRobot(R1);
    assertEquals(Set.of(), robots(StoredRobot::carried), "nobody knows of it any more");
  }

  private @Nullable LastPlace place() {
    return store.storedRobots().getFirst().place();
  }

  @Test
  void aRobotThatWasRemovedIsGoneUntilItIsAddedAgain() {
    store.saveRobot(R1);
    store.saveRobot(R2);
    store.saveService("r1", false, List.of());

    store.removeRobot("r1", List.of());

    assertEquals(List.of(R2), store.robots());
    store.removeRobot("r1", List.of()); // it may be repeated
    assertThrows(StoreException.class, () -> store.removeRobot("nobody", List.of()));
    store.saveRobot(R1);
    assertEquals(Set.of("r1", "r2"), names(store.robots()));
    assertEquals(Set.of(), robots(StoredRobot::outOfService));
  }

  private Set<String> robots(Predicate<StoredRobot> condition) {
    return store.storedRobots().stream()
        .filter(condition)
        .map(StoredRobot::name)
        .collect(Collectors.toSet());
  }

  private List<ChargeRecord> charges() {
    return store.storedRobots().stream().map(StoredRobot::charge).toList();
  }

  private static Set<String> names(List<RobotRecord> robots) {
    return robots.stream().map(RobotRecord::name).collect(Collectors.toSet());
  }

  @Test
  void whatARobotHasWorkedAndWhereItChargesComesBack() {
    store.saveRobot(R1);
    ChargeRecord rested = new ChargeRecord("r1", Duration.ZERO, null);
    assertEquals(List.of(rested), charges());

    ChargeRecord waits = new ChargeRecord("r1", Duration.ofMinutes(90), new Turn("C1", AT));
    store.saveCharge(waits, List.of());
    store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 7300, 5, "P1", true, null));

    assertEquals(List.of(waits), charges());
    store.saveCharge(rested, List.of());
    assertEquals(List.of(rested), charges());
  }

  @Test
  void whoIsOnHoldAndWhetherAllArePausedComesBack() {
    store.saveRobot(R1);
    store.saveHold("r1", true, List.of());
    Hold pause = new Hold("Ann", AT);
    store.savePause(pause, List.of());
    store.savePause(pause, List.of()); // twice is as once
    assertEquals(Set.of("r1"), robots(StoredRobot::held));
    assertEquals(Optional.of(pause), store.pause());

    store.saveHold("r1", false, List.of());
    store.savePause(null, List.of());
    assertEquals(Set.of(), robots(StoredRobot::held));
    assertEquals(Optional.empty(), store.pause());
  }

  @Test
  void floorsOnHoldComeBack() {
    Hold hold = new Hold("Ann", AT);
    store.saveFloorHold("hall", hold, List.of());
    store.saveFloorHold("hall", hold, List.of()); // twice is as once
    store.saveFloorHold("attic", new Hold("Max", AT), List.of());
    store.saveFloorHold("attic", null, List.of());

    assertEquals(Map.of("hall", hold), store.floorHolds());
  }

  @Test
  void theLastDriveOfARobotComesBackExactly() {
    store.saveRobot(R1);
    assertEquals(Optional.empty(), store.drive("r1"));
    Trajectory trajectory =
        new Trajectory(
            new Pose(0.1, 1 / 3.0, -3),
            List.of(new Segment(0.25, 0, 1.2), new Segment(0, 0.5, 0.1), Segment.shift(-0.1, 3)));
    store.saveDrive("r1", new StoredDrive(4, null, Phase.NONE, trajectory));
    StoredDrive second = new StoredDrive(9, 77L, Phase.TO_GOAL, trajectory);
    store.saveDrive("r1", second);
    assertEquals(Optional.of(second), store.drive("r1"));
  }

  /** As an earlier release stored it. */
  @Test
  void whatWasStoredWithoutShiftsIsRead() {
    assertEquals(
        List.of(new Segment(0.25, 0.5, 2)),
        TrajectoryJson.readSegments("[{\"v\":0.25,\"w\":0.5,\"t\":2}]"));
  }

  @Test
  void theEndOfADriveComesBackAsItWasChangedLast() {
    store.saveRobot(R1);
    store.saveDrive("r1", drive(4, segments(0, 100)));

    store.saveDriveEnd("r1", 4, 100, segments(100, 260));
    assertEquals(Optional.of(drive(4, segments(0, 260))), store.drive("r1"));
    store.saveDriveEnd("r1", 4, 190, List.of());
    assertEquals(Optional.of(drive(4, segments(0, 190))), store.drive("r1"));
    store.saveDriveEnd("r1", 4, 190, segments(190, 191));
    store.saveDriveEnd("r1", 4, 90, segments(1000, 1001));
    List<Segment> changed = new ArrayList<>(segments(0, 90));
    changed.addAll(segments(1000, 1001));
    assertEquals(Optional.of(drive(4, changed)), store.drive("r1"));

    store.saveDrive("r1", drive(5, segments(7, 9)));
    store.saveDriveEnd("r1", 4, 1, segments(0, 1)); // as when it is not known that it was stored
    assertEquals(Optional.of(drive(5, segments(7, 9))), store.drive("r1"));
    StoreException refusal =
        assertThrows(StoreException.class, () -> store.saveDriveEnd("r1", 6, 0, segments(0, 1)));
    assertTrue(refusal.isRefusal(), refusal::toString);
  }

  @Test
  void aChangedEndIsAShortRow() {
    store.saveRobot(R1);
    store.saveDrive("r1", drive(4, segments(0, 1000)));
    store.saveDriveEnd("r1", 4, 1000, segments(1000, 1003));

    assertEquals(
        List.of(segments(1000, 1003).toString()),
        database
            .jdbi()
            .withHandle(
                h ->
                    h.createQuery("select segments from drive_ends")
                        .mapTo(String.class)
                        .map(json -> TrajectoryJson.readSegments(json).toString())
                        .list()));
  }

  private static StoredDrive drive(long seq, List<Segment> segments) {
    return new StoredDrive(
        seq, null, Phase.NONE, new Trajectory(new Pose(0.1, 1 / 3.0, -3), segments));
  }

  /** Each another one, of numbers that are as long as they can be. */
  private static List<Segment> segments(int from, int to) {
    return IntStream.range(from, to)
        .mapToObj(i -> new Segment(-1e-300 / 3, -1e-300 / 7, i + 1 / 3.0))
        .toList();
  }
}
