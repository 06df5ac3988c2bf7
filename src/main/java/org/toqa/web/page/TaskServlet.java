package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.TaskWishes;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.Version;
import org.toqa.web.access.Caller;

/** One task: its state, its robots, what happened, and what people want of it. */
public final class TaskServlet extends PageServlet {
  /** The road of a task that goes well. */
  private static final List<TaskState> ROAD =
      List.of(
          TaskState.QUEUED,
          TaskState.ASSIGNED,
          TaskState.TO_OBJECT,
          TaskState.CARRYING,
          TaskState.RETURNING,
          TaskState.DONE);

  /** Those that have a name. */
  private static final Set<Integer> USUAL_PRIORITIES = Set.of(10, 0, -10);

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      notFound(request, response, "problem.noSuchTask");
      return;
    }
    offer(request, task.get());
    show(request, response, "task");
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      notFound(request, response, "problem.noSuchTask");
      return;
    }
    if (!TaskWishes.isAllowed(Caller.of(request), task.get())) {
      ErrorServlet.send(request, response, 403, Texts.of(request).get("problem.notYourTask"));
      return;
    }
    FieldErrors differences = differences(task.get(), request);
    if (!differences.isEmpty()) {
      offer(request, task.get());
      showConflict(request, response, "task", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    MissionEvent.Wish wish = wish(request, errors);
    long id = task.get().id();
    Optional<TaskView> changed =
        errors.isEmpty()
            ? accepted(request, FleetAnswers.await(services().fleet().wish(id, wish)), errors)
            : Optional.empty();
    if (changed.isPresent()) {
      goTo(request, response, "/tasks/" + id);
    } else {
      offer(request, task(request).orElse(task.get()));
      showAgain(request, response, "task", errors);
    }
  }

  private static FieldErrors differences(TaskView task, HttpServletRequest request) {
    int priority = task.task().priority();
    String shown =
        USUAL_PRIORITIES.contains(priority)
            ? Texts.of(request).get("newTask.priority." + priority)
            : String.valueOf(priority);
    return new Rivals(request, Version.of(task)).number("priority", priority, shown).differences();
  }

  private static MissionEvent.Wish wish(HttpServletRequest request, FieldErrors errors) {
    Caller caller = Caller.of(request);
    FormFields fields = new FormFields(request, errors);
    TaskWishes wishes = new TaskWishes(Texts.of(request), errors);
    return switch (Doors.lastSegment(request)) {
      case "hold" -> new MissionEvent.Hold(caller.name());
      case "resume" -> new MissionEvent.Resume(caller.name());
      case "priority" -> wishes.prioritise(caller, fields.number("priority"));
      case "cancel" -> wishes.cancel(caller, fields.text("load"));
      default -> wishes.answer(caller, fields.text("answer"));
    };
  }

  private Optional<TaskView> task(HttpServletRequest request) {
    return new Tasks(services()).byId(Doors.number(request, "id"));
  }

  private void offer(HttpServletRequest request, TaskView task) {
    request.setAttribute("task", task);
    request.setAttribute("version", Version.of(task));
    request.setAttribute("mayChange", TaskWishes.isAllowed(Caller.of(request), task));
    request.setAttribute("history", services().archive().history(task.id()));
    request.setAttribute("road", ROAD);
    request.setAttribute("reached", ROAD.indexOf(task.state()));
  }
}
