package org.toqa.store;

import java.sql.Types;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.mapper.Nested;
import org.jdbi.v3.core.statement.Update;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.LastPlace;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.geometry.Pose;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Trajectory;
import org.toqa.persistence.StoreException;

/** The tables of robots and of their places, within a transaction of somebody else. */
final class RobotTable {
  private RobotTable() {}

  static List<StoredRobot> storedRobots(Handle h) {
    Map<Long, List<DriveTable.End>> ends = DriveTable.ends(h);
    return h.createQuery(
            """
            select id, name, floor, host, port, max_load, parking, simulated, fingerprint, gateway, token,
              out_of_service, held, carried, worked_s, charger, charger_since, told_load,
              p.x, p.y, p.theta, p.diameter,
              case when p.robot_id is null or d.seq > p.drive then d.way end as begun,
              d.room_from, d.room_to, d.room_left, d.room_right,
              d.zone_x, d.zone_y, d.zone_width, d.zone_height
            from robots r left join places p on p.robot_id = r.id
              left join drives d on d.robot_id = r.id
            where not removed order by id
            """)
        .mapTo(StoredRobotRow.class)
        .map(row -> row.toStoredRobot(ends.getOrDefault(row.id(), List.of())))
        .list();
  }

  static int save(Handle h, RobotRecord robot) {
    return h.createUpdate(
            """
            insert into robots (name, floor, host, port, max_load, parking, simulated, fingerprint, gateway, token,
              availability, phase, last_seq)
            values (:name, :floor, :host, :port, :maxLoad, :parking, :simulated, :fingerprint, :gateway, :token, 1, 0, 0)
            on duplicate key update floor = values(floor), host = values(host), port = values(port),
              max_load = values(max_load), parking = values(parking), simulated = values(simulated),
              fingerprint = values(fingerprint), gateway = values(gateway), token = values(token),
              out_of_service = case when removed then false else out_of_service end,
              removed = false
            """)
        .bindMethods(robot)
        .execute();
  }

  /** Whether it was as it was before, and is changed. */
  static boolean update(Handle h, RobotRecord before, RobotRecord after) {
    String parking = before.parking();
    Fingerprint fingerprint = before.fingerprint();
    String gateway = before.gateway();
    RobotToken token = before.token();
    return h.createUpdate(
                """
                update robots set host = :host, port = :port, max_load = :maxLoad, parking = :parking,
                  fingerprint = :fingerprint, gateway = :gateway, token = :token
                where name = :name and not removed and host = :before.host and port = :before.port
                  and max_load = :before.maxLoad and coalesce(parking, '') = :beforeParking
                  and coalesce(fingerprint, '') = :beforeFingerprint
                  and coalesce(gateway, '') = :beforeGateway
                  and coalesce(token, '') = :beforeToken
                """)
            .bindMethods(after)
            .bindMethods("before", before)
            .bind("beforeParking", parking == null ? "" : parking)
            .bind("beforeFingerprint", fingerprint == null ? "" : fingerprint.hex())
            .bind("beforeGateway", gateway == null ? "" : gateway)
            .bind("beforeToken", token == null ? "" : token.secret())
            .execute()
        == 1;
  }

  static void remove(Handle h, String robot) {
    h.createUpdate(
            """
            update robots set removed = true, out_of_service = true, held = false, carried = false,
              parking = null, told_load = null, charger = null, charger_since = null, worked_s = 0
            where id = :id
            """)
        .bind("id", id(h, robot))
        .execute();
    h.execute("delete from mqtt_passwords where robot = ?", robot);
    h.execute("delete from reading_limits where robot = ?", robot);
    forgetPlace(h, robot);
  }

  static void move(Handle h, String robot, RobotMove move, double diameter) {
    h.createUpdate(
            """
            update robots set floor = :floor, parking = null, charger = null, carried = true
            where id = :id
            """)
        .bind("floor", move.floor())
        .bind("id", id(h, robot))
        .execute();
    var _ = savePlace(h, robot, move.pose(), diameter, lastDrive(h, robot));
  }

  static void saveFlag(Handle h, String column, String robot, boolean value) {
    h.createUpdate("update robots set " + column + " = :value where id = :id")
        .bind("value", value)
        .bind("id", id(h, robot))
        .execute();
  }

  /**
   * A robot with all that is stored of it.
   *
   * @param workedS seconds
   * @param toldLoad kilograms; null: it was never connected
   * @param x null: nobody knows, or a person said that it is not there any more
   * @param begun the way of the drive that it has begun since; null: it has not
   * @param roomFrom as the next three: room beside that way; null: it has none
   * @param zoneX as the next three: the free zone that it is; null: it is none
   */
  record StoredRobotRow(
      long id,
      @Nested RobotRecord robot,
      boolean outOfService,
      boolean held,
      boolean carried,
      double workedS,
      @Nullable String charger,
      @Nullable Instant chargerSince,
      @Nullable Double toldLoad,
      @Nullable Double x,
      @Nullable Double y,
      @Nullable Double theta,
      @Nullable Double diameter,
      @Nullable Trajectory begun,
      @Nullable Integer roomFrom,
      @Nullable Integer roomTo,
      @Nullable Double roomLeft,
      @Nullable Double roomRight,
      @Nullable Double zoneX,
      @Nullable Double zoneY,
      @Nullable Double zoneWidth,
      @Nullable Double zoneHeight) {
    StoredRobot toStoredRobot(List<DriveTable.End> ends) {
      Turn turn = charger == null || chargerSince == null ? null : new Turn(charger, chargerSince);
      Duration worked = Duration.ofMillis(Math.round(1000 * workedS));
      return new StoredRobot(
          robot,
          outOfService,
          held,
          carried,
          new ChargeRecord(robot.name(), worked, turn),
          toldLoad,
          place(ends));
    }

    private @Nullable PassingRoom room() {
      return roomFrom == null || roomTo == null || roomLeft == null || roomRight == null
          ? null
          : new PassingRoom(roomFrom, roomTo, roomLeft, roomRight, zone());
    }

    /** Without what is in it: only its robot has to know that. */
    private @Nullable FreeZone zone() {
      return zoneX == null || zoneY == null || zoneWidth == null || zoneHeight == null
          ? null
          : new FreeZone(zoneX, zoneY, zoneWidth, zoneHeight, 0, List.of());
    }

    private @Nullable LastPlace place(List<DriveTable.End> ends) {
      double width = diameter == null ? RobotCapabilities.UNKNOWN.footprint() : diameter;
      if (begun != null) {
        return new LastPlace(width, DriveTable.End.apply(ends, begun), room());
      }
      return x == null || y == null || theta == null
          ? null
          : LastPlace.standing(new Pose(x, y, theta), width);
    }
  }

  static int saveToldLoad(Handle h, String robot, double kilograms) {
    return h.createUpdate("update robots set told_load = :kilograms where id = :id")
        .bind("kilograms", kilograms)
        .bind("id", id(h, robot))
        .execute();
  }

  static int savePlace(Handle h, String robot, Pose pose, double diameter, long drive) {
    return placeUpdate(h, robot, drive)
        .bind("x", pose.x())
        .bind("y", pose.y())
        .bind("theta", pose.theta())
        .bind("diameter", diameter)
        .execute();
  }

  /** Whatever it has driven until now counts no more. */
  static void forgetPlace(Handle h, String robot) {
    placeUpdate(h, robot, lastDrive(h, robot))
        .bindNull("x", Types.DOUBLE)
        .bindNull("y", Types.DOUBLE)
        .bindNull("theta", Types.DOUBLE)
        .bindNull("diameter", Types.DOUBLE)
        .execute();
  }

  private static long lastDrive(Handle h, String robot) {
    return h.createQuery("select last_seq from robots where id = :id")
        .bind("id", id(h, robot))
        .mapTo(Long.class)
        .one();
  }

  private static Update placeUpdate(Handle h, String robot, long drive) {
    return h.createUpdate(
            """
            insert into places (robot_id, drive, x, y, theta, diameter)
            values (:id, :drive, :x, :y, :theta, :diameter)
            on duplicate key update drive = values(drive), x = values(x), y = values(y),
              theta = values(theta), diameter = values(diameter)
            """)
        .bind("id", id(h, robot))
        .bind("drive", drive);
  }

  static void saveCharge(Handle h, ChargeRecord record) {
    Turn turn = record.turn();
    h.createUpdate(
            """
            update robots set worked_s = :worked, charger = :charger, charger_since = :since
            where id = :id
            """)
        .bind("worked", record.worked().toMillis() / 1000.0)
        .bind("charger", turn == null ? null : turn.point())
        .bind("since", turn == null ? null : turn.since())
        .bind("id", id(h, record.robot()))
        .execute();
  }

  /**
   * @throws StoreException when there is no robot of that name
   */
  static long id(Handle h, String name) {
    return h.createQuery("select id from robots where name = :name")
        .bind("name", name)
        .mapTo(Long.class)
        .findOne()
        .orElseThrow(() -> new StoreException("There is no robot " + name + ".", null));
  }
}
