package org.toqa.fleet.manager;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Pose;
import org.toqa.grid.Disc;
import org.toqa.wording.Phrase;

/**
 * Moves a robot that was carried to another floor.
 *
 * <ol>
 *   <li>The other floor is not removed from here on until it has the robot; one that is removed is
 *       told of, and nothing is done.
 *   <li>Its floor gives it up, if it is out of service and has no task; where it is now is stored
 *       with that.
 *   <li>The listeners are told, who carry bodies that are simulated.
 *   <li>The other floor takes it, still out of service, and keeps its place free. As soon as it is
 *       connected it tells the robot where it stands, until the robot has taken that.
 * </ol>
 */
final class RobotMover {
  private final FloorDirectory floors;
  private final RobotFloors robots;
  private final List<MoveListener> listeners;

  /**
   * @param listeners are told of each robot that is moved
   */
  RobotMover(FloorDirectory floors, RobotFloors robots, List<MoveListener> listeners) {
    this.floors = floors;
    this.robots = robots;
    this.listeners = listeners;
  }

  CompletionStage<Answer<RobotView>> move(String robot, RobotMove move, String user) {
    Optional<FloorEntry> from = robots.floorOf(robot).flatMap(floors::find);
    Optional<FloorEntry> to = floors.find(move.floor());
    if (from.isEmpty()) {
      return done(new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(robot)));
    }
    if (to.isEmpty()) {
      return done(new Answer.Rejected<>("floor", floors.noSuchFloor(move.floor())));
    }
    if (from.get() == to.get()) {
      return done(
          new Answer.Rejected<>("floor", Phrase.ALREADY_ON_FLOOR.with(robot, move.floor())));
    }
    if (!new Disc(PlaceCheck.SMALLEST_RADIUS)
        .isFreeAt(to.get().map().grid(), move.pose().position())) {
      return done(new Answer.Rejected<>("x", Phrase.CANNOT_STAND_THERE.with()));
    }
    Optional<String> other = standingAt(to.get(), move.pose());
    if (other.isPresent()) {
      return done(new Answer.Rejected<>("x", Phrase.LOCATE_TAKEN.with(other.get())));
    }
    CompletionStage<Answer<RobotView>> carried =
        to.get().ask(target -> carry(robot, from.get(), to.get(), target, move, user));
    return FloorEntry.orIfRemoved(
        carried, () -> new Answer.Rejected<>("floor", floors.noSuchFloor(move.floor())));
  }

  /** While the other floor is asked, it is not removed; it counts the robot among its own. */
  private CompletionStage<Answer<RobotView>> carry(
      String robot,
      FloorEntry from,
      FloorEntry to,
      FloorFleet target,
      RobotMove move,
      String user) {
    robots.come(robot, to.name());
    return from.ask(floor -> floor.giveRobot(robot, move, user))
        .whenComplete(
            (given, _) -> {
              if (given instanceof Answer.Accepted<RobotView>) {
                robots.set(robot, to.name());
              } else {
                robots.stay(robot);
              }
            })
        .thenCompose(
            given ->
                given instanceof Answer.Accepted<RobotView>(RobotView view)
                    ? take(view.record(), to, target, move)
                    : done(given));
  }

  /**
   * Who is where no other robot can stand, since it says so, or is simulated and so was not carried
   * away.
   */
  private static Optional<String> standingAt(FloorEntry floor, Pose place) {
    return floor.snapshots().latest().robots().stream()
        .filter(robot -> robot.state() != RobotState.OUT_OF_SERVICE || robot.record().simulated())
        .filter(robot -> robot.telemetry().pose() != null)
        .filter(robot -> isTooNear(robot, place))
        .map(RobotView::name)
        .findFirst();
  }

  private static boolean isTooNear(RobotView robot, Pose place) {
    Pose pose = robot.telemetry().pose();
    double apart = robot.capabilities().footprint() / 2 + PlaceCheck.SMALLEST_RADIUS;
    return pose != null && pose.distanceTo(place) < apart;
  }

  private CompletionStage<Answer<RobotView>> take(
      RobotRecord robot, FloorEntry to, FloorFleet target, RobotMove move) {
    listeners.forEach(listener -> listener.moved(robot.name(), to.map(), move.pose()));
    return target.takeRobot(robot.movedTo(to.name()));
  }

  private static <T> CompletionStage<Answer<T>> done(Answer<T> answer) {
    return CompletableFuture.completedFuture(answer);
  }
}
