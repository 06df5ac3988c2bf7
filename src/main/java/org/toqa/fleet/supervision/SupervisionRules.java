package org.toqa.fleet.supervision;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.SeenBox;
import org.toqa.mission.TaskState;

/**
 * What follows from what is seen, weighed and done: steps 3 to 5 of CMCT's cycle over the fleet's
 * own tasks. Steps 1 and 2, that low robots charge first, are the fleet's own.
 *
 * <ol>
 *   <li>A box that the cameras see, and that no task has, lies there; at its target it is done.
 *   <li>A box whose task was delivered is done. Whose task has ended otherwise is not where it was,
 *       and is looked for again.
 *   <li>A box that the arm weighed as more than one worker carries gives its task back, and is
 *       ordered anew for two.
 *   <li>Every box that is found and has no task is ordered, while others are carried; without that
 *       overlap only when no worker works.
 * </ol>
 *
 * A function over values: time, pictures and tasks are handed in.
 */
final class SupervisionRules {
  /** Metres: what a camera sees elsewhere by more was moved. */
  private static final double SAME_PLACE = 0.1;

  /** Metres: a box that lies so near to its target is there. */
  private static final double AT_TARGET = 0.3;

  private final double threshold;

  /**
   * @param threshold kilograms up to which one worker carries a box alone
   */
  SupervisionRules(double threshold) {
    this.threshold = threshold;
  }

  double threshold() {
    return threshold;
  }

  /** Whether it was weighed, and one worker does not carry it alone. */
  boolean isForTwo(SupervisedBox box) {
    return box.isHeavierThan(threshold);
  }

  /**
   * @param isMissing whether a box is not where it was, so that it is looked for anew
   * @param toGiveBack tasks of one worker whose boxes are too heavy for it
   * @param toOrder boxes to be ordered
   */
  record Step(
      Supervision next, boolean isMissing, List<Long> toGiveBack, List<SupervisedBox> toOrder) {}

  /**
   * One look.
   *
   * @param seconds since the last one, of the fleet's time
   * @param archive the tasks that the snapshot does not show any more
   */
  Step step(
      Supervision before,
      FleetSnapshot snapshot,
      double seconds,
      LongFunction<Optional<TaskView>> archive) {
    List<SupervisedBox> boxes = new ArrayList<>();
    List<Long> toGiveBack = new ArrayList<>();
    boolean isMissing = false;
    Collection<SeenBox> inView = inView(before, snapshot);
    for (SupervisedBox box : before.boxes().values()) {
      SupervisedBox now = box;
      Long task = box.task();
      if (!box.delivered() && task != null) {
        Optional<TaskView> view = task(snapshot, task).or(() -> archive.apply(task));
        now = followed(box, view, snapshot);
        isMissing |= now.task() == null && now.place() == null;
        if (view.flatMap(SupervisionRules::weighedTooHeavy).isPresent()) {
          toGiveBack.add(task);
        }
      }
      boxes.add(now.delivered() || now.task() != null ? now : seen(now, inView));
    }
    Supervision next =
        before
            .withBoxes(boxes)
            .withIdle(before.idleSeconds() + seconds * idleWorkers(before, snapshot));
    return new Step(next, isMissing, toGiveBack, toOrder(next, snapshot));
  }

  private static Collection<SeenBox> inView(Supervision supervision, FleetSnapshot snapshot) {
    return view(supervision, snapshot).map(CameraView::boxes).orElse(List.of());
  }

  /** What the supervisor's cameras see; empty: it is not heard, or they see nothing at all. */
  static Optional<CameraView> view(Supervision supervision, FleetSnapshot snapshot) {
    return robot(snapshot, supervision.supervisor())
        .filter(robot -> robot.state().isFit())
        .map(robot -> robot.telemetry().readings().camera());
  }

  static Optional<RobotView> robot(FleetSnapshot snapshot, String name) {
    return snapshot.robots().stream().filter(robot -> robot.name().equals(name)).findFirst();
  }

  /** Boxes that lie somewhere: those that were found, and that no robot has in its hand. */
  static List<BoxView> lying(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.boxes().values().stream()
        .filter(box -> box.place() != null || box.delivered())
        .filter(box -> box.delivered() || !isInHand(box, snapshot))
        .map(
            box ->
                new BoxView(
                    box.number(),
                    box.delivered() || box.place() == null ? box.target() : box.place(),
                    box.delivered()))
        .toList();
  }

  private static boolean isInHand(SupervisedBox box, FleetSnapshot snapshot) {
    Long task = box.task();
    return task != null
        && task(snapshot, task).filter(view -> view.state() == TaskState.CARRYING).isPresent();
  }

  private static Optional<TaskView> task(FleetSnapshot snapshot, long id) {
    return snapshot.tasks().stream().filter(task -> task.id() == id).findFirst();
  }

  private static SupervisedBox seen(SupervisedBox box, Collection<SeenBox> inView) {
    return inView.stream()
        .filter(seen -> seen.box() == box.number())
        .map(SeenBox::place)
        .findFirst()
        .map(
            there -> {
              Vec2 known = box.place();
              SupervisedBox found =
                  known != null && known.distanceTo(there) < SAME_PLACE ? box : box.seenAt(there);
              return there.distanceTo(box.target()) < AT_TARGET ? found.atTarget() : found;
            })
        .orElse(box);
  }

  private SupervisedBox followed(
      SupervisedBox box, Optional<TaskView> view, FleetSnapshot snapshot) {
    if (view.isEmpty()) {
      return box.missing(); // a person has deleted it
    }
    TaskView task = view.get();
    SupervisedBox weighed =
        weighedTooHeavy(task).or(() -> weightInHand(task, snapshot)).map(box::weighing).orElse(box);
    return switch (task.state()) {
      case RETURNING, DONE -> weighed.atTarget();
      case CANCELLED, FAILED ->
          task.task().arm() != null && weighed.isHeavierThan(threshold)
              ? weighed.withoutTask()
              : weighed.missing();
      case QUEUED, ASSIGNED, TO_OBJECT, CARRYING -> weighed;
    };
  }

  /** Kilograms, where the arm asks since what it has weighed is too heavy for it. */
  private static Optional<Double> weighedTooHeavy(TaskView task) {
    return task.needs() == null ? Optional.empty() : task.needs().weighed();
  }

  private static Optional<Double> weightInHand(TaskView task, FleetSnapshot snapshot) {
    return task.state() == TaskState.CARRYING && task.task().arm() != null
        ? task.robots().stream()
            .flatMap(name -> robot(snapshot, name).stream())
            .map(robot -> robot.telemetry().readings().arm())
            .map(arm -> arm == null ? null : arm.load())
            .flatMap(SupervisionRules::stream)
            .findFirst()
        : Optional.empty();
  }

  private static Stream<Double> stream(@Nullable Double value) {
    return Stream.ofNullable(value);
  }

  private static List<SupervisedBox> toOrder(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.overlaps() || !isAnyoneCarrying(supervision, snapshot)
        ? supervision.boxes().values().stream().filter(SupervisedBox::isToOrder).toList()
        : List.of();
  }

  /** Whether the supervisor may look for boxes. */
  static boolean maySearch(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.overlaps() || !isAnyoneCarrying(supervision, snapshot);
  }

  private static boolean isAnyoneCarrying(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.boxes().values().stream()
            .anyMatch(box -> box.task() != null && !box.delivered())
        || supervision.workers().stream()
            .flatMap(name -> robot(snapshot, name).stream())
            .anyMatch(robot -> robot.work().task() != null);
  }

  /** How many workers could work and have nothing to do though boxes are left. */
  private static long idleWorkers(Supervision supervision, FleetSnapshot snapshot) {
    return supervision.isAllDelivered()
        ? 0
        : supervision.workers().stream()
            .flatMap(name -> robot(snapshot, name).stream())
            .filter(robot -> robot.state().kind() == RobotState.Kind.OPERATIONAL)
            .filter(robot -> robot.work().task() == null && !robot.work().held())
            .filter(robot -> robot.work().charger() == null)
            .count();
  }
}
