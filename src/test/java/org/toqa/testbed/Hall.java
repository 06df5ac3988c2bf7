package org.toqa.testbed;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.fleet.RobotView.Work;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.SeenBox;
import org.toqa.mission.Phase;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** The floor that tests of pages and of the API show, with robots on it. */
public final class Hall {
  /** When the first snapshot of it was taken. */
  public static final Instant START = Instant.parse("2026-11-21T08:00:00Z");

  private Hall() {}

  /** A robot that parks at P1; one without a pose was never heard. */
  public static RobotView robot(
      String name, RobotState state, @Nullable Pose pose, String host, int port) {
    return new RobotView(
        record(name, host, port),
        RobotCapabilities.UNKNOWN,
        state,
        new Work(null, Phase.NONE, false, null, Phrase.IS_FREE.with()),
        pose == null
            ? new Telemetry(null, null, Readings.NONE, List.of(), null)
            : new Telemetry(pose, 0.84, Readings.NONE, List.of(), START),
        RemainingPath.NONE,
        null,
        null);
  }

  /** One with cameras that see all round, and these boxes. */
  public static RobotView seeing(RobotView robot, SeenBox... boxes) {
    Telemetry heard = robot.telemetry();
    Readings readings =
        new Readings(null, null, List.of(), null, null, null, new CameraView(4, List.of(boxes)));
    return robot.withTelemetry(
        new Telemetry(heard.pose(), heard.battery(), readings, List.of(), START));
  }

  /** One with an arm of 0.55 m that lifts 5 kg. */
  public static RobotView withArm(RobotView robot) {
    JointLimits joint = new JointLimits(-2.8, 2.8, 1.5, 3);
    Arm arm = new Arm(0.3, 0.25, new Pose(0.05, 0, 0), joint, joint, 5, new JointAngles(2, -2.6));
    return robot.withCapabilities(
        new RobotCapabilities(0.3, DriveSpeeds.DEFAULT, 5, 0.8, DriveKind.OMNI, 0, arm));
  }

  /** A robot that parks at P1; one elsewhere than here is a real one. */
  public static RobotRecord record(String name, String host, int port) {
    return RobotRecord.direct(name, "hall", host, port, 5, "P1", host.equals("127.0.0.1"), null);
  }

  /** A floor with an obstacle of 2 x 2 cells, those of a lost robot r6, and a standstill. */
  public static FloorView crowdedFloor() {
    return Views.floor(
        "hall",
        null,
        new CellRuns(List.of(375, 2, 415, 2)), // rows 9 and 10, columns 15 and 16
        Map.of("r6", new CellRuns(List.of(490, 2, 530, 2))), // rows 12 and 13, columns 10 and 11
        List.of(
            new StandstillView(
                List.of("r2", "r3"),
                List.of(new Vec2(2.25, 0.75), new Vec2(7.35, 2.85)),
                START,
                Phrase.RING_OF_WAITS.with(
                    Sentence.names(List.of("r2", "r3")),
                    Sentence.joined(
                        Phrase.LISTED,
                        List.of(
                            Sentence.of(new Vec2(2.25, 0.75)),
                            Sentence.of(new Vec2(7.35, 2.85))))))),
        List.of(
            new FaultyCharger(
                "C1",
                new Vec2(10.95, 5.25),
                START,
                Phrase.CHARGER_IS_FAULTY.with("C1", "r2", Phrase.MINUTES.with(10)))),
        List.of(),
        new ChargerShortage(2, 4, Phrase.TOO_FEW_CHARGERS.with(4.6, 2, 4)));
  }

  /** 12 m x 6 m in cells of 0.3 m, walls around and one wall with a passage. */
  public static FloorMap floor() {
    int width = 40;
    int height = 20;
    BitSet occupied = new BitSet();
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean edge = row == 0 || row == height - 1 || column == 0 || column == width - 1;
        boolean wall = column == 20 && (row < 8 || row > 11);
        boolean shelf = row == 6 && column > 5 && column < 15;
        occupied.set(row * width + column, edge || wall || shelf);
      }
    }
    return new FloorMap(
        "hall",
        new OccupancyGrid(width, height, 0.3, Vec2.ZERO, occupied),
        List.of(place("Dock A", 1.05, 5.25), place("Shelf 3", 10.35, 1.05)),
        List.of(place("P1", 1.05, 0.75), place("P2", 2.25, 0.75), place("P3", 3.45, 0.75)),
        List.of(place("C1", 10.95, 5.25)));
  }

  private static Place place(String name, double x, double y) {
    return new Place(name, new Vec2(x, y));
  }
}
