package org.toqa.agent.firmware;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.PathProgress;
import org.toqa.agent.firmware.FirmwareCommand.Path;
import org.toqa.agent.firmware.FirmwareCommand.Poll;
import org.toqa.agent.firmware.FirmwareCommand.Segments;
import org.toqa.motion.Segment;

/**
 * Brings a path into the microcontroller's queue.
 *
 * <ol>
 *   <li>The frame that begins the path, with its first segments, goes out until the status names
 *       the path. Its number is one that the microcontroller did not have before, so a frame that
 *       comes twice begins nothing anew.
 *   <li>Then each frame carries the segments that come next, numbered, as far as the queue has
 *       room, and whether to go on. What the status does not show to have arrived goes out again;
 *       the microcontroller passes over what it has.
 *   <li>A path that the microcontroller has dropped is not begun once more.
 * </ol>
 */
final class PathSender {

  /** Numbers of paths and segments in a frame. */
  private static final int NUMBERS = 1 << 16;

  private long path;
  private int number;
  private boolean begun;
  private int completed;
  private @Nullable Segments lastSent;

  /** What to send next. */
  FirmwareCommand next(DrivePath order, FirmwareStatus status) {
    if (order.number() != path) {
      begin(order.number(), status);
    }
    boolean isDriven = isDriven(status);
    begun |= isDriven;
    if (!begun) {
      return new Path(
          number,
          order.start(),
          order.pace(),
          order.limits().acceleration(),
          order.limits().turnAcceleration(),
          order.onward(),
          first(order.segments(), Path.MOST_SEGMENTS));
    }
    if (!isDriven) {
      return new Poll();
    }
    Segments next = nextSegments(order, status);
    lastSent = next;
    return next;
  }

  private void begin(long newPath, FirmwareStatus status) {
    path = newPath;
    number = Math.max(1, ((number == 0 ? status.path() : number) + 1) % NUMBERS);
    begun = false;
    completed = 0;
    lastSent = null;
  }

  private Segments nextSegments(DrivePath order, FirmwareStatus status) {
    updateCompleted(status);
    int known = completed + Chassis.QUEUE_LENGTH - status.freeSegments();
    Segments sent = lastSent; // the status does not tell of it yet
    int next =
        sent != null && sent.first() == known % NUMBERS ? known + sent.segments().size() : known;
    int room = Math.max(0, Chassis.QUEUE_LENGTH - (next - completed));
    return new Segments(
        number,
        next % NUMBERS,
        order.onward(),
        first(order.segmentsFrom(next), Math.min(room, Segments.MOST_SEGMENTS)));
  }

  private boolean isDriven(FirmwareStatus status) {
    return status.path() == number && status.isOnPath();
  }

  /** The microcontroller's count wraps around. */
  private void updateCompleted(FirmwareStatus status) {
    completed += Math.floorMod(status.segmentsDriven() - completed, NUMBERS);
  }

  private static List<Segment> first(List<Segment> segments, int most) {
    return segments.subList(0, Math.min(most, segments.size()));
  }

  /** How far the microcontroller has come; null while it drives no path of this daemon. */
  @Nullable PathProgress progress(FirmwareStatus status) {
    if (path == 0 || !isDriven(status)) {
      return null;
    }
    updateCompleted(status);
    return new PathProgress(
        path,
        completed,
        status.coveredSeconds(),
        status.pace(),
        status.state() == FirmwareStatus.State.PATH_STANDING);
  }
}
