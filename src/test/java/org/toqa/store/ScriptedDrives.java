package org.toqa.store;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.mission.Phase;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** Drives and how they go on, of many sizes, the same again for the same robot and number. */
final class ScriptedDrives {
  private static final int MOST_SEGMENTS = 300;
  private static final int MOST_NEW_SEGMENTS = 40;

  private ScriptedDrives() {}

  static StoredDrive begun(String robot, long seq) {
    Random random = random(robot, seq, 0);
    return new StoredDrive(
        seq,
        null,
        Phase.NONE,
        new Trajectory(
            new Pose(random.nextDouble(), 0, 0),
            segments(random, 1 + random.nextInt(MOST_SEGMENTS))));
  }

  /** The next one of the drive. */
  static DriveExtension extension(String robot, StoredDrive drive) {
    int number = drive.extensions() + 1;
    Random random = random(robot, drive.seq(), number);
    int from = random.nextInt(drive.trajectory().segments().size() + 1);
    return new DriveExtension(
        drive.seq(), number, from, segments(random, random.nextInt(MOST_NEW_SEGMENTS)));
  }

  /** A drive after so many extensions. */
  static StoredDrive extended(String robot, long seq, int extensions) {
    StoredDrive drive = begun(robot, seq);
    while (drive.extensions() < extensions) {
      drive = drive.with(extension(robot, drive));
    }
    return drive;
  }

  private static Random random(String robot, long seq, int number) {
    return new Random(31 * (31L * robot.hashCode() + seq) + number);
  }

  private static List<Segment> segments(Random random, int count) {
    return Stream.generate(() -> new Segment(random.nextDouble(), 0, random.nextDouble()))
        .limit(count)
        .toList();
  }
}
