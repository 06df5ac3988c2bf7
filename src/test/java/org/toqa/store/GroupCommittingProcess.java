package org.toqa.store;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.GroupCommitter;
import org.toqa.fleet.StoreWriter;

/**
 * Has the drives of some robots stored beside each other, as a floor has, until it is killed. Of
 * each change that it is told to be stored it says robot, drive and extension, and then makes the
 * robot's next one.
 */
public final class GroupCommittingProcess {
  static final List<String> ROBOTS = IntStream.range(0, 8).mapToObj(i -> "r" + i).toList();

  private static final int EXTENSIONS = 20;

  /** The begin of a drive is one. */
  static final int CHANGES_A_DRIVE = 1 + EXTENSIONS;

  private final JdbiFleetStore store;

  private GroupCommittingProcess(JdbiFleetStore store) {
    this.store = store;
  }

  /**
   * @param args the file of the database, without its ending, and the number of the first drives
   */
  public static void main(String[] args) throws InterruptedException {
    Database database = CommittingProcess.open(Path.of(args[0]));
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    GroupCommitter committer =
        new GroupCommitter("floor", store, FleetRuntime.USUAL, change -> System.exit(1));
    GroupCommittingProcess process = new GroupCommittingProcess(store);
    for (String robot : ROBOTS) {
      process.begin(robot, committer.writer(robot), Long.parseLong(args[1]));
    }
    Thread.currentThread().join(); // until it is killed
  }

  private void begin(String robot, StoreWriter writer, long seq) {
    StoredDrive drive = ScriptedDrives.begun(robot, seq);
    writer.write(() -> store.saveDrive(robot, drive), () -> stored(robot, writer, drive));
  }

  private void stored(String robot, StoreWriter writer, StoredDrive drive) {
    System.out.println(robot + " " + drive.seq() + " " + drive.extensions() + " .");
    if (drive.extensions() == EXTENSIONS) {
      begin(robot, writer, drive.seq() + 1);
    } else {
      DriveExtension extension = ScriptedDrives.extension(robot, drive);
      writer.write(
          () -> store.saveExtension(robot, extension),
          () -> stored(robot, writer, drive.with(extension)));
    }
  }
}
