package org.toqa.store;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.mission.Phase;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** Stores drives, one after the other, says each one that is stored, and ends without a warning. */
public final class CommittingProcess {
  static final String ROBOT = "r1";

  private static final int LEAST_COMMITS = 1500;
  private static final int MOST_COMMITS = 3000;

  private CommittingProcess() {}

  /** The database of a server. */
  static Database open(Path file) {
    return Database.open(Database.fileUrl(file), "", "");
  }

  /**
   * @param args the file of the database, without its ending, and the number of the first drive
   */
  public static void main(String[] args) {
    Database database = open(Path.of(args[0]));
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    long first = Long.parseLong(args[1]);
    int commits = ThreadLocalRandom.current().nextInt(LEAST_COMMITS, MOST_COMMITS);
    for (long seq = first; seq < first + commits; seq++) {
      store.saveDrive(ROBOT, drive(seq));
      System.out.println(seq);
    }
    Runtime.getRuntime().halt(137);
  }

  /** Of many sizes, so that the parts of the file that become free do not suit what comes next. */
  private static StoredDrive drive(long seq) {
    int size = ThreadLocalRandom.current().nextInt(1, 400);
    List<Segment> segments = Collections.nCopies(size, new Segment(0.25, 0, seq));
    return new StoredDrive(seq, null, Phase.NONE, new Trajectory(new Pose(0, 0, 0), segments));
  }
}
