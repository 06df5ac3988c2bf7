package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.function.BiFunction;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.TaskWishes;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** One task with its history, and what people want of it. */
public final class TaskServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, task(request));
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskView task = task(request);
    if (!TaskWishes.isAllowed(Caller.of(request), task)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourTask")).raised();
    }
    MissionEvent.Wish wish = wish(request);
    send(
        request,
        response,
        accepted(request, FleetAnswers.await(services().fleet().wish(task.id(), wish))));
  }

  private static MissionEvent.Wish wish(HttpServletRequest request) throws IOException {
    Caller caller = Caller.of(request);
    return switch (Doors.lastSegment(request)) {
      case "hold" -> new MissionEvent.Hold(caller.name());
      case "resume" -> new MissionEvent.Resume(caller.name());
      case "priority" ->
          read(request, (wishes, fields) -> wishes.prioritise(caller, fields.number("priority")));
      case "cancel" ->
          JsonFields.isSent(request)
              ? read(request, (wishes, fields) -> wishes.cancel(caller, fields.text("load")))
              : new MissionEvent.Cancel(caller.name(), null);
      default -> read(request, (wishes, fields) -> wishes.answer(caller, fields.text("answer")));
    };
  }

  private static MissionEvent.Wish read(
      HttpServletRequest request, BiFunction<TaskWishes, JsonFields, MissionEvent.Wish> reader)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    MissionEvent.Wish wish = reader.apply(new TaskWishes(Texts.of(request), errors), fields);
    fields.refuseUnknown();
    refuseIfAny(errors);
    return wish;
  }

  private TaskView task(HttpServletRequest request) {
    return new Tasks(services())
        .byId(Doors.number(request, "id"))
        .orElseThrow(() -> Problem.of(404, Texts.of(request).get("problem.noSuchTask")).raised());
  }

  private void send(HttpServletRequest request, HttpServletResponse response, TaskView task)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        TaskJson.withHistory(task, services().archive().history(task.id())));
  }
}
