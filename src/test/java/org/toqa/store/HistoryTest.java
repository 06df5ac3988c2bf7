package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.UUID;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.NullAndEmptySource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.history.BatteryLevel;
import org.toqa.fleet.history.EventArchive.Entry;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.fleet.history.FloorScenes;
import org.toqa.fleet.history.FloorTracks;
import org.toqa.fleet.history.LoadPlace;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PlannedPath;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.fleet.history.UtilisationRecord;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.testbed.LabTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What is kept, found again and pruned; here on H2, in {@code MySqlHistoryTest} on MySQL. */
class HistoryTest extends DatabaseTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00.123Z");
  private static final Filter ALL = new Filter(null, null, null, null, null, null, true);

  private static final Locale ARABIC = Locale.of("ar");

  private JdbiFleetStore store;
  private JdbiEventArchive history;
  private JdbiTrackStore tracks;
  private JdbiSceneStore scenes;
  private HistoryPruner pruning;

  @BeforeEach
  void openStore() {
    store = new JdbiFleetStore(database.jdbi());
    history = new JdbiEventArchive(database.jdbi());
    tracks = new JdbiTrackStore(database.jdbi());
    scenes = new JdbiSceneStore(database.jdbi());
    pruning = new HistoryPruner(database.jdbi());
  }

  @Test
  void drivingByHandEndsInTheHistoryWhenTheServerIsUpAgainAfterACrash() {
    for (String robot : List.of("r1", "r2")) {
      store.addEvents(
          List.of(
              new EventRecord(
                  AT,
                  EventKind.ROBOT_MANUAL_BEGAN,
                  null,
                  robot,
                  "Max",
                  Phrase.MANUAL_DRIVE_BEGAN.with("Max", robot))));
    }
    store.addEvents(
        List.of(
            new EventRecord(
                AT.plusSeconds(1),
                EventKind.ROBOT_MANUAL_ENDED,
                null,
                "r1",
                "Max",
                Phrase.MANUAL_DRIVE_ENDED.with("Max", "r1"))));

    for (int start = 0; start < 2; start++) { // the second one finds nothing to end
      new JdbiServerRuns(database.jdbi()).begin(AT.plusSeconds(60));
    }

    assertEquals(
        List.of(
            "Max no longer drives r2 by hand: the server ended meanwhile",
            "Max stopped driving r1 by hand"),
        history.events(ALL, Long.MAX_VALUE, 100).stream()
            .map(Entry::event)
            .filter(event -> event.kind().equals(EventKind.ROBOT_MANUAL_ENDED.text()))
            .map(EventRecord::text)
            .toList());
  }

  @Test
  void whatWasSaidIsReadInAnotherLanguageAfterARestart() {
    Sentence said =
        Phrase.CANCELLED_LOAD_STAYS.with(
            "Max",
            Phrase.LISTED_APART.with(
                Phrase.AT_PLACE.with(Sentence.of(new Vec2(1.5, -2))),
                Phrase.NOT_ENOUGH_FOR_TASK.with(18, 7L)));
    store.addEvents(List.of(new EventRecord(AT, "task.answered", 7L, null, "Max", said)));

    EventRecord found =
        new JdbiEventArchive(database.jdbi()).events(ALL, 100, 1).getFirst().event();

    assertEquals(
        "Cancelled by Max; the load stays at (1.50, -2.00); 18 % is not enough for task 7",
        found.text());
    assertEquals(said.text(ARABIC), found.sentence().text(ARABIC));
  }

  @ParameterizedTest
  @NullAndEmptySource
  @ValueSource(
      strings = {
        "{",
        "7",
        "{}",
        "[]",
        "[\"SAID_BY_A_LATER_SERVER\", \"r1\"]",
        "[\"HAS_PARKED\"]",
        "[\"HAS_PARKED\", \"r1\", \"r2\"]",
        "[\"TASK_ON_HOLD\", \"r1\"]",
        "[\"AT_PLACE\", [\"POINT\", 1]]"
      })
  void whatCannotBeReadIsTheEnglishText(@Nullable String stored) {
    store.addEvents(List.of(event(AT, "robot.held", null, "r1", "Max", "so it was")));
    database.jdbi().useHandle(h -> h.execute("update events set said = ?", stored));

    assertEquals(Sentence.verbatim("so it was"), found(ALL).getFirst().sentence());
  }

  @Test
  void whatIsTooLongForTheHistoryIsCutAndEnglish() {
    Sentence said = Phrase.REFUSED_A_COMMAND.with("r1", "no ".repeat(700));
    store.addEvents(List.of(new EventRecord(AT, "robot.held", null, "r1", "toqa", said)));

    Sentence found = found(ALL).getFirst().sentence();

    assertTrue(found.isVerbatim());
    assertEquals(500, found.english().length());
  }

  @Test
  void eventsAreFoundByRobotTaskUserKindAndTime() {
    EventRecord held = event(AT, "robot.held", null, "r1", "Max", "Max put r1 on hold");
    EventRecord lost = event(AT.plusSeconds(1), "task.robot-lost", 7L, "r1", "toqa", "lost");
    EventRecord seen = event(AT.plusSeconds(2), "floor.obstacle", null, "r2", "toqa", "box");
    store.addEvents(List.of(held, lost, seen));

    assertEquals(List.of(seen, lost, held), found(ALL));
    assertEquals(List.of(lost, held), found(new Filter(null, "r1", null, null, null, null, true)));
    assertEquals(List.of(lost), found(new Filter(7L, null, null, null, null, null, true)));
    assertEquals(List.of(held), found(new Filter(null, null, "Max", null, null, null, true)));
    assertEquals(List.of(seen), found(new Filter(null, null, null, "floor", null, null, true)));
    assertEquals(
        List.of(seen), found(new Filter(null, null, null, "floor.obstacle", null, null, true)));
    assertEquals(List.of(), found(new Filter(null, null, null, "obstacle", null, null, true)));
    assertEquals(
        List.of(lost),
        found(new Filter(null, null, null, null, AT.plusSeconds(1), AT.plusSeconds(2), true)));
  }

  @Test
  void robotsThatWereRemovedAreStillNamed() {
    for (String name : List.of("r2", "r1")) {
      store.saveRobot(RobotRecord.direct(name, "lab", "127.0.0.1", 7275, 5, null, false, null));
    }
    store.removeRobot("r1", List.of());

    assertEquals(List.of("r1", "r2"), history.robots());
  }

  @Test
  void pagesFollowEachOtherWithoutGaps() {
    store.addEvents(
        IntStream.range(0, 25)
            .mapToObj(i -> event(AT.plusSeconds(i), "fleet.paused", null, null, "Max", "no. " + i))
            .toList());

    List<Entry> first = history.events(ALL, Long.MAX_VALUE, 10);
    List<Entry> second = history.events(ALL, first.getLast().id(), 10);

    assertEquals("no. 24", first.getFirst().event().text());
    assertEquals("no. 15", first.getLast().event().text());
    assertEquals("no. 14", second.getFirst().event().text());
  }

  @Test
  void aChangeThatIsRepeatedIsToldOnce() {
    store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 7275, 5, null, true, null));
    List<EventRecord> events =
        List.of(
            event(AT, "robot.held", null, "r1", "Max", "Max put r1 on hold").onFloor("lab"),
            event(AT, "robot.held", null, "r1", "Max", "and said why").onFloor("lab"));

    store.saveHold("r1", true, events);
    store.saveHold("r1", true, events);

    assertEquals(events.reversed(), found(ALL));
  }

  @Test
  void aWithdrawnTaskWasNeverThere() {
    UUID submission = UUID.randomUUID();
    store.addTasks(List.of(new Submission(task("ghost"), submission)));
    TransportTask stays = added(task("stays"));

    store.withdrawTasks(List.of(submission, UUID.randomUUID()));

    assertEquals(1, store.count());
    assertEquals(List.of(EventRecord.added(stays)), found(ALL));
  }

  @Test
  void aTrackComesBackToTheMillimetre() {
    store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 7275, 5, null, true, null));
    TrackPoint early = new TrackPoint("r1", AT, new Vec2(1.234, -5.678));
    TrackPoint late = new TrackPoint("r1", AT.plusSeconds(5), new Vec2(2, 0));
    tracks.add(List.of(late, early, new TrackPoint("nobody", AT, new Vec2(0, 0))));
    tracks.add(List.of(early));

    List<TrackPoint> all = tracks.track("r1", AT);
    assertEquals(List.of(early.at(), late.at()), all.stream().map(TrackPoint::at).toList());
    assertEquals(0, early.position().distanceTo(all.getFirst().position()), 1e-9);
    assertEquals(1, tracks.track("r1", AT.plusMillis(1)).size());
  }

  @Test
  void tracksOfAPeriodComeWithWhatIsBesideIt() {
    for (String robot : List.of("r1", "r2", "r3")) {
      store.saveRobot(RobotRecord.direct(robot, "lab", "127.0.0.1", 7275, 5, null, true, null));
    }
    tracks.add(points("r1", -30, -20, -10, 0, 10, 20, 30, 40));
    tracks.add(points("r2", -3000));
    tracks.add(points("r3", 5));

    FloorTracks found =
        tracks.tracksOf(List.of("r1", "r2"), AT, AT.plusSeconds(30), 3); // as many as there are

    assertEquals(AT.plusSeconds(30), found.until());
    assertEquals(
        Map.of("r1", List.of(-20L, -10L, 0L, 10L, 20L, 30L), "r2", List.of(-3000L)),
        seconds(found));
  }

  @Test
  void tracksEndEarlierWhereTheyAreTooMany() {
    for (String robot : List.of("r1", "r2")) {
      store.saveRobot(RobotRecord.direct(robot, "lab", "127.0.0.1", 7275, 5, null, true, null));
    }
    tracks.add(points("r1", 0, 10, 20, 30));
    tracks.add(points("r2", 5, 15, 25));

    FloorTracks first = tracks.tracksOf(List.of("r1", "r2"), AT, AT.plusSeconds(60), 3);
    FloorTracks rest = tracks.tracksOf(List.of("r1", "r2"), first.until(), AT.plusSeconds(60), 4);

    assertEquals(AT.plusSeconds(15), first.until()); // 0, 5 and 10 are three
    assertEquals(Map.of("r1", List.of(0L, 10L, 20L), "r2", List.of(5L, 15L)), seconds(first));
    assertEquals(AT.plusSeconds(60), rest.until());
    assertEquals(
        Map.of("r1", List.of(0L, 10L, 20L, 30L), "r2", List.of(5L, 15L, 25L)), seconds(rest));
    assertEquals(Map.of(), seconds(tracks.tracksOf(List.of(), AT, AT.plusSeconds(60), 3)));
  }

  @Test
  void loadsAndPathsOfAPeriodAreThoseOfAnyMomentOfIt() {
    store.saveRobot(RobotRecord.direct("r1", "lab", "h", 7275, 5, null, false, null));
    LoadPlace lay = load(7, -60, 10L, new Vec2(1.234, -5.678));
    LoadPlace carried = load(7, 10, null, null, "r1", "r2");
    LoadPlace before = load(8, -60, 0L, new Vec2(1, 1));
    LoadPlace after = load(9, 30, null, new Vec2(1, 1));
    PlannedPath path = path("r1", -5, null);
    scenes.save(List.of(after, lay, carried, before), List.of(path, path("nobody", 0, null)));
    assertEquals(List.of(after, carried), sorted(scenes.openLoads()));
    assertEquals(List.of(path), scenes.openPaths());

    FloorScenes found = scenes.scenesOf("lab", AT, AT.plusSeconds(30), 2);

    assertEquals(new FloorScenes(AT.plusSeconds(30), List.of(lay, carried), List.of(path)), found);
    assertEquals(
        new FloorScenes(AT.plusSeconds(10), List.of(lay), List.of(path)),
        scenes.scenesOf("lab", AT, AT.plusSeconds(30), 1),
        "up to where one too many begins");
    assertEquals(List.of(), scenes.scenesOf("elsewhere", AT, AT.plusSeconds(30), 2).loads());
  }

  @Test
  void aLoadAndAPathEndWhereTheyWere() {
    store.saveRobot(RobotRecord.direct("r1", "lab", "h", 7275, 5, null, false, null));
    scenes.save(List.of(load(7, 0, null, Vec2.ZERO)), List.of(path("r1", 0, null)));
    LoadPlace lay = load(7, 0, 5L, Vec2.ZERO);
    PlannedPath driven = path("r1", 0, 6L);

    scenes.save(List.of(lay), List.of(driven));

    assertEquals(
        new FloorScenes(AT.plusSeconds(9), List.of(lay), List.of(driven)),
        scenes.scenesOf("lab", AT, AT.plusSeconds(9), 9));
    assertEquals(List.of(), scenes.openLoads());
    assertEquals(List.of(), scenes.openPaths());
    scenes.save(List.of(load(8, 0, null, Vec2.ZERO)), List.of());
    pruning.pruneTracks(AT.plusSeconds(6));
    assertEquals(List.of(driven), scenes.scenesOf("lab", AT, AT.plusSeconds(9), 9).paths());
    assertEquals(
        List.of(8L),
        scenes.scenesOf("lab", AT, AT.plusSeconds(9), 9).loads().stream()
            .map(LoadPlace::load)
            .toList(),
        "what still lies there stays, however old it is");
  }

  private static List<LoadPlace> sorted(List<LoadPlace> loads) {
    return loads.stream().sorted(Comparator.comparing(LoadPlace::load).reversed()).toList();
  }

  private static LoadPlace load(
      long load, long from, @Nullable Long until, @Nullable Vec2 position, String... robots) {
    return new LoadPlace(
        load,
        load,
        "lab",
        AT.plusSeconds(from),
        until == null ? null : AT.plusSeconds(until),
        position,
        List.of(robots),
        robots.length == 0 ? null : new LoadSize(1.2, 0.8));
  }

  private static PlannedPath path(String robot, long from, @Nullable Long until) {
    return new PlannedPath(
        robot,
        "lab",
        AT.plusSeconds(from),
        until == null ? null : AT.plusSeconds(until),
        List.of(new Vec2(1.234, -5.678), new Vec2(2, 0)));
  }

  private static List<TrackPoint> points(String robot, long... seconds) {
    return LongStream.of(seconds)
        .mapToObj(s -> new TrackPoint(robot, AT.plusSeconds(s), new Vec2(s, 0)))
        .toList();
  }

  private static Map<String, List<Long>> seconds(FloorTracks tracks) {
    return tracks.points().entrySet().stream()
        .collect(
            Collectors.toMap(
                Map.Entry::getKey,
                track ->
                    track.getValue().stream()
                        .map(point -> Duration.between(AT, point.at()).toSeconds())
                        .toList()));
  }

  @Test
  void whatIsTooOldIsPrunedAndWhatIsOpenStays() {
    store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 7275, 5, null, true, null));
    TransportTask done = added(task("done"));
    TransportTask open = added(task("open"));
    Mission ended = new Mission(done, TaskState.CANCELLED, List.of(), false, null, null, null);
    store.saveMission(ended, AT, List.of());
    EventRecord recent = event(AT.plus(Duration.ofDays(2)), "fleet.paused", null, null, "A", "b");
    store.addEvents(List.of(event(AT, "fleet.paused", null, null, "Max", "old"), recent));
    tracks.add(
        IntStream.range(0, 2500)
            .mapToObj(i -> new TrackPoint("r1", AT.plusSeconds(i), new Vec2(i, 0)))
            .toList());

    JdbiUtilisationStore uses = new JdbiUtilisationStore(database.jdbi());
    uses.save(
        IntStream.of(0, 2)
            .mapToObj(day -> AT.plus(Duration.ofDays(day)))
            .map(
                at ->
                    new UtilisationRecord(
                        "r1", at, Map.of(RobotActivity.IDLE, Duration.ofMinutes(30)), 7, 0))
            .toList());

    tracks.addBatteryLevels(
        List.of(
            new BatteryLevel("r1", AT, 0.5),
            new BatteryLevel("r1", AT.plusSeconds(1990), 0.49),
            new BatteryLevel("r1", AT.plusSeconds(3000), 0.48)));
    assertEquals(
        List.of(
            new BatteryLevel("r1", AT.plusSeconds(1990), 0.49),
            new BatteryLevel("r1", AT.plusSeconds(3000), 0.48)),
        tracks.batteryLevels("r1", AT.plusSeconds(2500)),
        "and the last one from before");

    assertEquals(2000, pruning.pruneTracks(AT.plusSeconds(2000)));
    assertEquals(1, tracks.batteryLevels("r1", AT).size());
    assertEquals(1, pruning.pruneHistory(AT.plus(Duration.ofDays(1))));

    assertEquals(500, tracks.track("r1", AT).size());
    LocalDate day = LocalDate.of(2026, 11, 21);
    Period days = Period.of(day, day.plusDays(2), ZoneOffset.UTC);
    assertEquals(
        7,
        new JdbiStatisticsArchive(database.jdbi())
            .statistics(days)
            .total()
            .metres()); // of the third day
    assertEquals(List.of(recent, EventRecord.added(open)), found(ALL));
    assertEquals(1, store.count());
  }

  private List<EventRecord> found(Filter filter) {
    return history.events(filter, Long.MAX_VALUE, 100).stream().map(Entry::event).toList();
  }

  private static EventRecord event(
      Instant at,
      String kind,
      @Nullable Long task,
      @Nullable String robot,
      String who,
      String text) {
    return new EventRecord(at, kind, task, robot, who, Sentence.verbatim(text));
  }

  private TransportTask added(TransportTask task) {
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private static TransportTask task(String name) {
    return LabTask.of(name, "Ann", AT);
  }
}
