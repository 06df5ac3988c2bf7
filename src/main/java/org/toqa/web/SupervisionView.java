package org.toqa.web;

import jakarta.servlet.http.HttpServletRequest;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionReport;
import org.toqa.wording.Sentence;

/**
 * A supervision with its boxes and robots, as people and programs see it.
 *
 * @param report null: it does not run, or was not looked at yet
 * @param robots the supervisor first
 */
public record SupervisionView(
    Supervision supervision,
    @Nullable SupervisionReport report,
    List<Box> boxes,
    List<Robot> robots) {

  /** How far a box is. */
  public enum BoxState {
    /** Nobody knows where it is. */
    SOUGHT,
    /** It was found, and is no task yet. */
    FOUND,
    /** A task waits for workers. */
    ORDERED,
    /** Workers are on their way to it. */
    FETCHED,
    CARRIED,
    DELIVERED
  }

  /**
   * A box and who is about it.
   *
   * @param robots those of its task
   * @param reason why it waits; null: it does not, or nobody knows
   * @param question what a person must decide at its task; null: nothing
   */
  public record Box(
      SupervisedBox box,
      BoxState state,
      List<String> robots,
      @Nullable Sentence reason,
      @Nullable Sentence question) {

    /** Whether a person may say that it is not to be carried. */
    public boolean mayBeLeftOut() {
      return state == BoxState.SOUGHT || state == BoxState.FOUND || state == BoxState.ORDERED;
    }
  }

  /**
   * A robot that takes part.
   *
   * @param view null: there is no robot of that name any more
   * @param box the number of the one it is about; null: of none
   */
  public record Robot(
      String name, boolean isSupervisor, @Nullable RobotView view, @Nullable Integer box) {}

  /** The last one of a floor; empty: none has worked there yet. */
  public static Optional<SupervisionView> of(Services services, String floor) {
    return services.supervisor().latest(floor).map(last -> of(services, last));
  }

  public static SupervisionView of(Services services, Supervision supervision) {
    FleetSnapshot snapshot = services.fleet().snapshots().latest();
    SupervisionReport report =
        supervision.isRunning()
            ? services.supervisor().report(supervision.floor()).orElse(null)
            : null;
    List<Box> boxes =
        supervision.boxes().values().stream()
            .map(box -> box(box, task(box, snapshot, services), report))
            .toList();
    List<Robot> robots =
        Stream.concat(Stream.of(supervision.supervisor()), supervision.workers().stream())
            .map(name -> robot(name, supervision, boxes, snapshot))
            .toList();
    return new SupervisionView(supervision, report, boxes, robots);
  }

  /** The one that carries it or is to; empty: none does. */
  private static Optional<TaskView> task(
      SupervisedBox box, FleetSnapshot snapshot, Services services) {
    Long id = box.task();
    return box.delivered() || id == null
        ? Optional.empty()
        : snapshot.tasks().stream()
            .filter(task -> task.id() == id)
            .findFirst()
            .or(() -> services.archive().task(id))
            .filter(task -> !task.state().isEnded());
  }

  private static Box box(
      SupervisedBox box, Optional<TaskView> task, @Nullable SupervisionReport report) {
    if (box.delivered()) {
      return new Box(box, BoxState.DELIVERED, List.of(), null, null);
    }
    if (task.isEmpty()) {
      Sentence refusal = report == null ? null : report.refusal(box.number()).orElse(null);
      return new Box(
          box, box.place() == null ? BoxState.SOUGHT : BoxState.FOUND, List.of(), refusal, null);
    }
    TaskView view = task.get();
    BoxState state =
        switch (view.state()) {
          case QUEUED -> BoxState.ORDERED;
          case ASSIGNED, TO_OBJECT -> BoxState.FETCHED;
          case CARRYING -> BoxState.CARRIED;
          case RETURNING, DONE, CANCELLED, FAILED -> BoxState.DELIVERED;
        };
    return new Box(
        box,
        state,
        view.robots(),
        view.waitingFor(),
        view.needs() == null ? null : view.needs().question());
  }

  private static Robot robot(
      String name, Supervision supervision, List<Box> boxes, FleetSnapshot snapshot) {
    return new Robot(
        name,
        name.equals(supervision.supervisor()),
        snapshot.robots().stream().filter(r -> r.name().equals(name)).findFirst().orElse(null),
        boxes.stream()
            .filter(box -> box.robots().contains(name))
            .map(box -> box.box().number())
            .findFirst()
            .orElse(null));
  }

  /** The number of a box at {@code {box}} of a path; 0, which none has, where it is no number. */
  public static int boxOfPath(HttpServletRequest request) {
    long number = RequestPath.number(request, "box");
    return number <= Integer.MAX_VALUE ? (int) number : 0;
  }

  /** Whether a box was found nowhere, so that a person may let the supervisor look again. */
  public boolean isAnyLost() {
    return report != null
        && report.hasSeenAll()
        && boxes.stream().anyMatch(box -> box.state() == BoxState.SOUGHT);
  }
}
