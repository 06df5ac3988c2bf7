package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorMap;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Orders;
import org.toqa.web.RequestPath;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Permission;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TaskCommandReader;
import org.toqa.web.input.Version;

/** One task: its state, its robots, what happened, and the commands that an operator may give. */
public final class TaskPage extends PageHandler {
  /** The states of a task that goes well, in order. */
  private static final List<TaskState> TIMELINE =
      List.of(
          TaskState.QUEUED,
          TaskState.ASSIGNED,
          TaskState.TO_OBJECT,
          TaskState.CARRYING,
          TaskState.RETURNING,
          TaskState.DONE);

  /** Those that have a name. */
  private static final Set<Integer> NAMED_PRIORITIES = Set.of(10, 0, -10);

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
      return;
    }
    addAttributes(request, task.get());
    show(request, response, "task");
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, (reader, fields, user, task) -> new MissionEvent.Hold(user.name()));
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, (reader, fields, user, task) -> new MissionEvent.Resume(user.name()));
  }

  public static void prioritise(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(
        request,
        response,
        (reader, fields, user, task) ->
            reader.readPriority(
                user,
                fields.number("priority"),
                request.getParameter("version") == null ? null : task.task().priority()));
  }

  public static void cancel(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(
        request,
        response,
        (reader, fields, user, task) -> reader.readCancel(user, fields.text("load")));
  }

  /** Whoever is at the stop says it, whose the task may be. */
  public static void goOn(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
      return;
    }
    change(
        request,
        response,
        task.get(),
        (reader, fields, user, seen) -> reader.readGoOn(user, fields.number("stop")));
  }

  public static void answer(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(
        request,
        response,
        (reader, fields, user, task) -> reader.readAnswer(user, fields.text("answer")));
  }

  public static void moveLoad(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(
        request,
        response,
        (reader, fields, user, task) -> reader.readMove(user, fields, floorOf(request, task)));
  }

  private static FloorMap floorOf(HttpServletRequest request, TaskView task) {
    return new Tasks(services(request)).floorOf(task);
  }

  public static void removeLoad(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(
        request,
        response,
        (reader, fields, user, task) -> new MissionEvent.RemoveLoad(user.name()));
  }

  /** It is in no list then, and has no page. */
  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = changeableTask(request, response);
    if (task.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    String user = Caller.of(request).name();
    Optional<TaskView> deleted =
        acceptedValue(
            request,
            FleetAnswers.await(services(request).fleet().deleteTask(task.get(), user)),
            errors);
    if (deleted.isPresent()) {
      redirect(request, response, "/tasks?deleted=" + deleted.get().id());
    } else {
      addAttributes(request, task(request).orElse(task.get()));
      showAgain(request, response, "task", errors);
    }
  }

  public static void follow(HttpServletRequest request, HttpServletResponse response)
      throws IOException, ServletException {
    setFollowed(request, response, true);
  }

  public static void unfollow(HttpServletRequest request, HttpServletResponse response)
      throws IOException, ServletException {
    setFollowed(request, response, false);
  }

  /** Of the reader alone: whose the task is matters not. */
  private static void setFollowed(
      HttpServletRequest request, HttpServletResponse response, boolean followed)
      throws IOException, ServletException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
      return;
    }
    services(request)
        .traces()
        .setFollowed(Caller.of(request).account().id(), task.get().id(), followed);
    redirect(request, response, "/tasks/" + task.get().id());
  }

  /** The task, if the reader may change it; an error is sent otherwise. */
  static Optional<TaskView> changeableTask(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
    } else if (!TaskCommandReader.canChange(Caller.of(request), task.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.notYourTask"));
      return Optional.empty();
    }
    return task;
  }

  /** Reads a command from the fields of a form. */
  @FunctionalInterface
  private interface FormReader {
    /**
     * @param task what the entries were compared with
     */
    MissionEvent.OperatorCommand read(
        TaskCommandReader reader, FormFields fields, Caller user, TaskView task);
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, FormReader form)
      throws ServletException, IOException {
    Optional<TaskView> task = changeableTask(request, response);
    if (task.isPresent()) {
      change(request, response, task.get(), form);
    }
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, TaskView task, FormReader form)
      throws ServletException, IOException {
    FieldErrors differences = differences(task, request);
    if (!differences.isEmpty()) {
      addAttributes(request, task);
      showConflict(request, response, "task", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    MissionEvent.OperatorCommand command =
        form.read(
            new TaskCommandReader(Texts.of(request), errors),
            new FormFields(request, errors),
            Caller.of(request),
            task);
    long id = task.id();
    Optional<TaskView> changed =
        errors.isEmpty()
            ? acceptedValue(
                request,
                FleetAnswers.await(services(request).fleet().commandTask(id, command)),
                errors)
            : Optional.empty();
    if (changed.isPresent()) {
      redirect(request, response, "/tasks/" + id);
    } else {
      addAttributes(request, task(request).orElse(task));
      showAgain(request, response, "task", errors);
    }
  }

  private static FieldErrors differences(TaskView task, HttpServletRequest request) {
    int priority = task.task().priority();
    String shown =
        NAMED_PRIORITIES.contains(priority)
            ? Texts.of(request).get("newTask.priority." + priority)
            : String.valueOf(priority);
    return new EditConflict(request, Version.of(task))
        .compareNumber("priority", priority, shown)
        .differences();
  }

  private static Optional<TaskView> task(HttpServletRequest request) {
    return new Tasks(services(request)).task(RequestPath.number(request, "id"));
  }

  private static void addAttributes(HttpServletRequest request, TaskView task) {
    request.setAttribute("task", task);
    OrderView order =
        new Orders(services(request)).of(List.of(task)).values().stream().findFirst().orElse(null);
    request.setAttribute("order", order);
    request.setAttribute("isStopped", order != null && order.isStopped(task));
    request.setAttribute("stations", floorOf(request, task).stations());
    request.setAttribute("version", Version.of(task));
    request.setAttribute("mayGoOn", Caller.of(request).has(Permission.ORDER));
    request.setAttribute("stopEntries", StopEntries.of(task.task()).orElse(null));
    request.setAttribute("mayOrder", Caller.of(request).mayOrder());
    request.setAttribute("mayChange", TaskCommandReader.canChange(Caller.of(request), task));
    request.setAttribute(
        "followed",
        services(request).traces().isFollowed(Caller.of(request).account().id(), task.id()));
    request.setAttribute("history", services(request).archive().history(task.id()));
    request.setAttribute(
        "negotiation",
        services(request).fleet().snapshots().latest().negotiations().get(task.id()));
    request.setAttribute(
        "held",
        services(request).fleet().snapshots().latest().floors().stream()
            .flatMap(floor -> floor.heldLoads().stream())
            .filter(load -> load.task() == task.id())
            .findFirst()
            .orElse(null));
    List<TaskState> timeline =
        TIMELINE.stream()
            .filter(state -> state != TaskState.CARRYING || !task.task().isDrive())
            .toList();
    request.setAttribute("timeline", timeline);
    request.setAttribute("reached", timeline.indexOf(task.state()));
  }
}
