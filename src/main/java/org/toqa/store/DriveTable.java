package org.toqa.store;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.mission.Phase;
import org.toqa.motion.Trajectory;

/**
 * The tables of robots' last drives, within a transaction of somebody else. An extension adds rows
 * of its own segments and changes none that are there; a drive that begins removes those of the one
 * before.
 */
final class DriveTable {
  private static final String ADD_SEGMENTS =
      """
      insert into drive_segments (robot_id, drive, extension, first_segment, segments)
      select d.robot_id, d.seq, :extension, :first, :segments
      from drives d join robots r on r.id = d.robot_id where r.name = :robot and d.seq = :drive
      on duplicate key update segments = values(segments)
      """;

  private DriveTable() {}

  static void save(Handle h, String robot, StoredDrive drive) {
    long id = RobotTable.id(h, robot);
    h.createUpdate(
            """
            insert into drives (robot_id, seq, task_id, phase, way, created_at)
            values (:id, :seq, :task, :phase, :way, :at)
            on duplicate key update seq = values(seq), task_id = values(task_id), phase = values(phase),
              way = values(way), created_at = values(created_at)
            """)
        .bind("id", id)
        .bind("seq", drive.seq())
        .bind("task", drive.task())
        .bind("phase", drive.phase())
        .bind("way", new Trajectory(drive.trajectory().start(), List.of()))
        .bind("at", Instant.now())
        .execute();
    h.createUpdate("update robots set last_seq = :seq where id = :id")
        .bind("seq", drive.seq())
        .bind("id", id)
        .execute();
    h.createUpdate("delete from drive_segments where robot_id = :id").bind("id", id).execute();
    addSegments(h, robot, new DriveExtension(drive.seq(), 0, 0, drive.trajectory().segments()));
  }

  static void saveExtension(Handle h, String robot, DriveExtension extension) {
    addSegments(h, robot, extension);
  }

  private static void addSegments(Handle h, String robot, DriveExtension extension) {
    List<byte[]> rows = SegmentBytes.write(extension.segments());
    PreparedBatch batch = h.prepareBatch(ADD_SEGMENTS);
    int first = extension.from();
    for (byte[] row : rows) {
      batch
          .bind("robot", robot)
          .bind("drive", extension.drive())
          .bind("extension", extension.number())
          .bind("first", first)
          .bind("segments", row)
          .add();
      first += SegmentBytes.count(row);
    }
    batch.execute();
  }

  static Optional<StoredDrive> drive(Handle h, String robot) {
    return drives(h, "where r.name = :robot", Map.of("robot", robot)).values().stream().findFirst();
  }

  /** By robot, that of its last drive. */
  static Map<String, Trajectory> trajectories(Handle h) {
    Map<String, Trajectory> trajectories = new HashMap<>();
    drives(h, "where not r.removed", Map.of())
        .forEach((robot, drive) -> trajectories.put(robot, drive.trajectory()));
    return trajectories;
  }

  /** By robot. In one statement, so that nothing is changed between a drive and its segments. */
  private static Map<String, StoredDrive> drives(
      Handle h, String condition, Map<String, String> values) {
    Map<String, StoredDrive> drives = new HashMap<>();
    h.createQuery(
            """
            select r.name as robot, d.seq, d.task_id as task, d.phase, d.way as begun,
              s.extension, s.first_segment, s.segments
            from drives d join robots r on r.id = d.robot_id
              left join drive_segments s on s.robot_id = d.robot_id and s.drive = d.seq
            """
                + condition
                + " order by d.robot_id, s.extension, s.first_segment")
        .bindMap(values)
        .mapTo(DriveRow.class)
        .forEach(
            row ->
                drives.compute(
                    row.robot(),
                    (robot, drive) -> row.appliedTo(drive == null ? row.toStoredDrive() : drive)));
    return drives;
  }

  /**
   * A drive with some of its segments.
   *
   * @param begun with the segments only where it was stored before {@code drive_segments} was
   * @param segments null: it has none
   */
  record DriveRow(
      String robot,
      long seq,
      @Nullable Long task,
      Phase phase,
      Trajectory begun,
      @Nullable Integer extension,
      @Nullable Integer firstSegment,
      byte @Nullable [] segments) {
    private StoredDrive toStoredDrive() {
      return new StoredDrive(seq, task, phase, begun);
    }

    /** What changes a part that was refused is left out: the robot was not sent it either. */
    private StoredDrive appliedTo(StoredDrive drive) {
      if (extension == null
          || firstSegment == null
          || segments == null
          || firstSegment > drive.trajectory().segments().size()) {
        return drive;
      }
      return drive.with(
          new DriveExtension(seq, extension, firstSegment, SegmentBytes.read(segments)));
    }
  }
}
