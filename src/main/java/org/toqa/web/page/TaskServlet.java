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
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TaskCommandReader;
import org.toqa.web.input.Version;

/** One task: its state, its robots, what happened, and what people want of it. */
public final class TaskServlet extends PageServlet {
  /** The road of a task that goes well. */
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

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
      return;
    }
    addAttributes(request, task.get());
    show(request, response, "task");
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = task(request);
    if (task.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTask");
      return;
    }
    if (!TaskCommandReader.canChange(Caller.of(request), task.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.notYourTask"));
      return;
    }
    FieldErrors differences = differences(task.get(), request);
    if (!differences.isEmpty()) {
      addAttributes(request, task.get());
      showConflict(request, response, "task", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    MissionEvent.OperatorCommand command = command(request, errors);
    long id = task.get().id();
    Optional<TaskView> changed =
        errors.isEmpty()
            ? acceptedValue(
                request, FleetAnswers.await(services().fleet().commandTask(id, command)), errors)
            : Optional.empty();
    if (changed.isPresent()) {
      redirect(request, response, "/tasks/" + id);
    } else {
      addAttributes(request, task(request).orElse(task.get()));
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

  private static MissionEvent.OperatorCommand command(
      HttpServletRequest request, FieldErrors errors) {
    Caller caller = Caller.of(request);
    FormFields fields = new FormFields(request, errors);
    TaskCommandReader reader = new TaskCommandReader(Texts.of(request), errors);
    return switch (RequestPath.lastSegment(request)) {
      case "hold" -> new MissionEvent.Hold(caller.name());
      case "resume" -> new MissionEvent.Resume(caller.name());
      case "priority" -> reader.readPriority(caller, fields.number("priority"));
      case "cancel" -> reader.readCancel(caller, fields.text("load"));
      default -> reader.readAnswer(caller, fields.text("answer"));
    };
  }

  private Optional<TaskView> task(HttpServletRequest request) {
    return new Tasks(services()).task(RequestPath.number(request, "id"));
  }

  private void addAttributes(HttpServletRequest request, TaskView task) {
    request.setAttribute("task", task);
    request.setAttribute("version", Version.of(task));
    request.setAttribute("mayChange", TaskCommandReader.canChange(Caller.of(request), task));
    request.setAttribute("history", services().archive().history(task.id()));
    request.setAttribute("road", TIMELINE);
    request.setAttribute("reached", TIMELINE.indexOf(task.state()));
  }
}
