package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
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
class H2CompactorTest {
  private static final int COMMITS = 1000;

  /** More than three times of what is in it; without compaction it is twenty times as large. */
  private static final long LARGEST_FILE = 1_500_000;

  /** What some fifty commits leave behind that are not forced to the disk yet, and a good deal. */
  private static final long LARGEST_FILE_IN_USE = 3_000_000;

  /** The pace of a fleet at work; nothing waits for it to be over. */
  private static final int COMMIT_EACH_MILLIS = 20;

  @TempDir private Path folder;

  @Test
  @Timeout(120)
  void fileIsNotMuchLargerThanWhatIsInIt() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      store.saveRobot(new RobotRecord("r1", "lab", "127.0.0.1", 1, 5, null, true, null));
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
  @Timeout(120)
  void fileIsSmallAlsoWhileItIsWrittenTo() throws Exception {
    Path file = folder.resolve("toqa.mv.db");
    try (Database database = open()) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      store.saveRobot(new RobotRecord("r1", "lab", "127.0.0.1", 1, 5, null, true, null));
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

  private Database open() {
    return Database.open(Database.fileUrl(folder.resolve("toqa")), "", "");
  }

  private static StoredDrive drive(long seq) {
    Segment segment = new Segment(0.25, 0, seq);
    List<Segment> segments = Collections.nCopies(200, segment);
    return new StoredDrive(seq, null, Phase.NONE, new Trajectory(new Pose(0, 0, 0), segments));
  }
}
