package org.toqa.store;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.persistence.StoreException;

/**
 * The tables of the robots' last drives, within a transaction of somebody else. A drive is kept as
 * it began; what has become of its end since is kept beside it, in parts, so that a robot whose way
 * goes on costs a short row and not the whole way.
 */
final class DriveTable {
  /** In one row, which has room for numbers of any length. */
  private static final int SEGMENTS_A_ROW = 40;

  private DriveTable() {}

  /**
   * A part of a drive's end.
   *
   * @param first how many segments come before it; what was there after them is void
   */
  record End(long robotId, int first, String segments) {
    /**
     * @param ends of that way, in the order of their first segments
     */
    static Trajectory apply(List<End> ends, Trajectory begun) {
      List<Segment> segments = new ArrayList<>(begun.segments());
      for (End end : ends) {
        segments.subList(end.first(), segments.size()).clear();
        segments.addAll(TrajectoryJson.readSegments(end.segments()));
      }
      return new Trajectory(begun.start(), segments);
    }
  }

  /** By the ids of robots, in the order of their first segments. */
  static Map<Long, List<End>> ends(Handle h) {
    return h
        .createQuery("select robot_id, first, segments from drive_ends order by robot_id, first")
        .mapTo(End.class)
        .list()
        .stream()
        .collect(Collectors.groupingBy(End::robotId));
  }

  static Optional<StoredDrive> drive(Handle h, String robot) {
    List<End> ends =
        h.createQuery(
                """
                select robot_id, first, segments from drive_ends
                where robot_id in (select id from robots where name = :robot) order by first
                """)
            .bind("robot", robot)
            .mapTo(End.class)
            .list();
    return h.createQuery(
            """
            select d.seq, d.task_id as task, d.phase, d.way as trajectory
            from drives d join robots r on r.id = d.robot_id where r.name = :robot
            """)
        .bind("robot", robot)
        .mapTo(StoredDrive.class)
        .findOne()
        .map(
            drive ->
                new StoredDrive(
                    drive.seq(), drive.task(), drive.phase(), End.apply(ends, drive.trajectory())));
  }

  static int save(Handle h, String robot, StoredDrive drive) {
    long id = RobotTable.id(h, robot);
    h.createUpdate(
            """
            insert into drives (robot_id, seq, task_id, phase, way, created_at)
            values (:id, :seq, :task, :phase, :way, :at)
            on duplicate key update seq = values(seq), task_id = values(task_id), phase = values(phase),
              way = values(way), created_at = values(created_at),
              room_from = null, room_to = null, room_left = null, room_right = null,
              zone_x = null, zone_y = null, zone_width = null, zone_height = null
            """)
        .bind("id", id)
        .bind("seq", drive.seq())
        .bind("task", drive.task())
        .bind("phase", drive.phase())
        .bind("way", drive.trajectory())
        .bind("at", Instant.now())
        .execute();
    deleteEnd(h, id, 0);
    return h.createUpdate("update robots set last_seq = :seq where id = :id")
        .bind("seq", drive.seq())
        .bind("id", id)
        .execute();
  }

  /**
   * Nothing, where a later drive is stored already: this is said again after that.
   *
   * @param from how many segments stay
   * @throws StoreException the drive is not stored
   */
  static int saveEnd(Handle h, String robot, long seq, int from, List<Segment> segments) {
    long id = RobotTable.id(h, robot);
    long last =
        h.createQuery("select seq from drives where robot_id = :id")
            .bind("id", id)
            .mapTo(Long.class)
            .findOne()
            .orElse(0L);
    if (last < seq) {
      throw new StoreException(
          StoreException.Kind.REFUSED, "Drive " + seq + " of " + robot + " is not stored.", null);
    }
    return last == seq ? replaceEnd(h, id, from, segments) : 0;
  }

  /** Nothing, where another drive is stored. */
  static int saveRoom(Handle h, String robot, long seq, @Nullable PassingRoom room) {
    FreeZone zone = room == null ? null : room.zone();
    return h.createUpdate(
            """
            update drives set room_from = :from, room_to = :to, room_left = :left, room_right = :right,
              zone_x = :x, zone_y = :y, zone_width = :width, zone_height = :height
            where robot_id = :id and seq = :seq
            """)
        .bind("id", RobotTable.id(h, robot))
        .bind("seq", seq)
        .bind("from", room == null ? null : room.from())
        .bind("to", room == null ? null : room.to())
        .bind("left", room == null ? null : room.left())
        .bind("right", room == null ? null : room.right())
        .bind("x", zone == null ? null : zone.x())
        .bind("y", zone == null ? null : zone.y())
        .bind("width", zone == null ? null : zone.width())
        .bind("height", zone == null ? null : zone.height())
        .execute();
  }

  private static int replaceEnd(Handle h, long id, int from, List<Segment> segments) {
    deleteEnd(h, id, from);
    PreparedBatch rows =
        h.prepareBatch(
            "insert into drive_ends (robot_id, first, segments) values (:id, :first, :segments)");
    int i = 0;
    do { // at least one, which says that what was after it is void
      List<Segment> part = segments.subList(i, Math.min(i + SEGMENTS_A_ROW, segments.size()));
      rows.bind("id", id)
          .bind("first", from + i)
          .bind("segments", TrajectoryJson.writeSegments(part))
          .add();
      i += SEGMENTS_A_ROW;
    } while (i < segments.size());
    return rows.execute().length;
  }

  private static void deleteEnd(Handle h, long id, int from) {
    h.createUpdate("delete from drive_ends where robot_id = :id and first >= :from")
        .bind("id", id)
        .bind("from", from)
        .execute();
  }
}
