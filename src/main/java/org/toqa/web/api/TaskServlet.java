package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.function.BiFunction;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TaskCommandReader;

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
    if (!TaskCommandReader.canChange(Caller.of(request), task)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourTask")).exception();
    }
    MissionEvent.OperatorCommand command = command(request);
    send(
        request,
        response,
        acceptedValue(
            request, FleetAnswers.await(services().fleet().commandTask(task.id(), command))));
  }

  private static MissionEvent.OperatorCommand command(HttpServletRequest request)
      throws IOException {
    Caller caller = Caller.of(request);
    return switch (RequestPath.lastSegment(request)) {
      case "hold" -> new MissionEvent.Hold(caller.name());
      case "resume" -> new MissionEvent.Resume(caller.name());
      case "priority" ->
          read(request, (wishes, fields) -> wishes.readPriority(caller, fields.number("priority")));
      case "cancel" ->
          JsonFields.hasBody(request)
              ? read(request, (wishes, fields) -> wishes.readCancel(caller, fields.text("load")))
              : new MissionEvent.Cancel(caller.name(), null);
      default ->
          read(request, (wishes, fields) -> wishes.readAnswer(caller, fields.text("answer")));
    };
  }

  private static MissionEvent.OperatorCommand read(
      HttpServletRequest request,
      BiFunction<TaskCommandReader, JsonFields, MissionEvent.OperatorCommand> reader)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    MissionEvent.OperatorCommand command =
        reader.apply(new TaskCommandReader(Texts.of(request), errors), fields);
    fields.refuseUnknown();
    throwIfAny(errors);
    return command;
  }

  private TaskView task(HttpServletRequest request) {
    return new Tasks(services())
        .task(RequestPath.number(request, "id"))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchTask")).exception());
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
