package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jdbi.v3.core.Jdbi;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Pose;
import org.toqa.mission.Phase;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** The file of the embedded database, with the settings that the server has. */
@Tag("full")
class H2CompactorTest {
  private static final int COMMITS = 1000;

  /** More than three times of what is in it; without compaction it is twenty times as large. */
  private static final long LARGEST_FILE = 1_500_000;

  /** What some fifty commits leave behind that are not forced to the disk yet, and a good deal. */
  private static final long LARGEST_FILE_IN_USE = 3_000_000;

  /** Ends a test that would wait for ever. */
  private static final int GUARD_SECONDS = 900;

  /** The pace of a fleet at work; nothing waits for it to be over. */
  private static final int COMMIT_EACH_MILLIS = 20;

  private static final int ROBOTS = 40;
  private static final int READ_COMMITS = 8_000;

  /** With drives that are larger together than a file that is left as it is. */
  private static final int MANY_ROBOTS = 300;

  /** Of the compactor's time, from one commit to the next. */
  private static final Duration FAST_PACE = Duration.ofMillis(10);

  @TempDir private Path folder;

  @Test
  @Timeout(GUARD_SECONDS)
  void fileIsNotMuchLargerThanWhatIsInIt() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 1, 5, null, true, null));
      for (int i = 1; i <= COMMITS; i++) {
        store.saveDrive("r1", drive(i));
      }
      while (Files.size(file) > LARGEST_FILE) {
        Thread.sleep(100);
      }
      assertEquals(drive(COMMITS), store.drive("r1").orElseThrow());
    }
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      assertEquals(drive(COMMITS), store.drive("r1").orElseThrow());
    }
  }

  /** First as fast as they can be, then one after the other, as in a fleet at work. */
  @Test
  @Timeout(GUARD_SECONDS)
  void fileIsSmallAlsoWhileItIsWrittenTo() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      store.saveRobot(RobotRecord.direct("r1", "lab", "127.0.0.1", 1, 5, null, true, null));
      int commits = 0;
      while (commits < COMMITS) {
        store.saveDrive("r1", drive(++commits));
      }
      while (Files.size(file) > LARGEST_FILE_IN_USE) {
        store.saveDrive("r1", drive(++commits));
        Thread.sleep(COMMIT_EACH_MILLIS);
      }
    }
  }

  /** As when the time of a simulated fleet goes forty times faster than the compactor's. */
  @Test
  void fileIsInProportionToItsContentAtAnyPace() throws Exception {
    MigratedFile.copyTo(folder);
    Path file = folder.resolve("toqa.mv.db");
    String url = H2Url.withSettings(Database.fileUrl(folder.resolve("toqa")));
    try (Connection connection = DriverManager.getConnection(url)) {
      Jdbi jdbi = Jdbi.create(connection);
      DatabaseTypes.register(jdbi);
      JdbiFleetStore store = new JdbiFleetStore(jdbi);
      H2Compactor compactor = new H2Compactor(jdbi);
      for (int robot = 0; robot < MANY_ROBOTS; robot++) {
        store.saveRobot(
            RobotRecord.direct("r" + robot, "lab", "127.0.0.1", 1, 5, null, true, null));
      }
      long largest = 0;
      Duration sinceLook = Duration.ZERO;
      for (int commit = 0; commit < 3 * MANY_ROBOTS; commit++) {
        store.saveDrive("r" + commit % MANY_ROBOTS, drive(1 + commit / MANY_ROBOTS));
        sinceLook = sinceLook.plus(FAST_PACE);
        if (sinceLook.compareTo(H2Compactor.INTERVAL) >= 0) {
          compactor.compact();
          sinceLook = Duration.ZERO;
        }
        largest = Math.max(largest, Files.size(file));
      }
      long content = DatabaseSize.ofH2File(file).contentBytes();
      compactor.close();
      assertTrue(largest < 3 * content, largest + " bytes for a content of " + content);
    }
  }

  /** Parts of the file are freed, moved and used again under those who read. */
  @Test
  @Timeout(GUARD_SECONDS)
  void readersFindAllWhileTheFileIsMadeSmaller() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      for (int robot = 0; robot < ROBOTS; robot++) {
        store.saveRobot(
            RobotRecord.direct("r" + robot, "lab", "127.0.0.1", 1, 5, null, true, null));
        store.saveDrive("r" + robot, drive(1));
      }
      AtomicBoolean isOver = new AtomicBoolean();
      FutureTask<Long> reader = new FutureTask<>(() -> readUntil(isOver, store));
      Thread.ofPlatform().start(reader);
      long largest = 0;
      for (int seq = 2; seq < READ_COMMITS / ROBOTS; seq++) {
        for (int robot = 0; robot < ROBOTS; robot++) {
          store.saveDrive("r" + robot, drive(seq));
        }
        largest = Math.max(largest, Files.size(file));
      }
      while (Files.size(file) > largest / 2) {
        Thread.sleep(100);
      }
      isOver.set(true);
      assertTrue(reader.get() > ROBOTS);
    }
  }

  private static long readUntil(AtomicBoolean isOver, JdbiFleetStore store) {
    long[] known = new long[ROBOTS];
    long reads = 0;
    while (!isOver.get()) {
      for (int robot = 0; robot < ROBOTS; robot++) {
        StoredDrive drive = store.drive("r" + robot).orElseThrow();
        assertEquals(drive(drive.seq()), drive);
        assertTrue(drive.seq() >= known[robot], "older than what was read before");
        known[robot] = drive.seq();
        reads++;
      }
    }
    return reads;
  }

  private Database open() {
    return Database.open(Database.fileUrl(folder.resolve("toqa")), "", "");
  }

  private static StoredDrive drive(long seq) {
    Segment segment = new Segment(0.25, 0, seq);
    List<Segment> segments = Collections.nCopies(200, segment);
    return new StoredDrive(seq, null, Phase.NONE, new Trajectory(new Pose(0, 0, 0), segments));
  }
}
