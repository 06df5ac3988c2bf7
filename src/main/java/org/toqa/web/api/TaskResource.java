package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.function.BiFunction;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorMap;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TransportTask;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.TaskCommandReader;
import org.toqa.web.input.TaskOrderReader;
import org.toqa.web.input.Version;

/** One task with its history, and the commands that an operator may give. */
public final class TaskResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, task(request));
  }

  /** All that is ordered, of a task that waits. */
  public static void edit(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskView task = changeableTask(request);
    requireVersion(Version.ofOrder(task), request);
    TaskOrder order = readBody(request, TaskOrderReader::read);
    String ifMatch = request.getHeader("If-Match");
    TransportTask seen = ifMatch == null || ifMatch.strip().equals("*") ? null : task.task();
    send(
        request,
        response,
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .fleet()
                    .editTask(task.id(), order, seen, Caller.of(request).name()))));
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    TaskView task = changeableTask(request);
    String user = Caller.of(request).name();
    acceptedValue(request, FleetAnswers.await(services(request).fleet().deleteTask(task, user)));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void follow(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    setFollowed(request, response, true);
  }

  public static void unfollow(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    setFollowed(request, response, false);
  }

  /** Of the caller alone: whose the task is matters not. */
  private static void setFollowed(
      HttpServletRequest request, HttpServletResponse response, boolean followed)
      throws IOException {
    TaskView task = task(request);
    services(request).traces().setFollowed(Caller.of(request).account().id(), task.id(), followed);
    send(request, response, task);
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(request, response, user -> new MissionEvent.Hold(user.name()));
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(request, response, user -> new MissionEvent.Resume(user.name()));
  }

  public static void prioritise(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(
        request,
        response,
        user ->
            read(
                request,
                (reader, fields) -> reader.readPriority(user, fields.number("priority"), null)));
  }

  /** Whoever is at the stop says it, whose the task may be. */
  public static void goOn(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(
        request,
        response,
        task(request),
        user ->
            JsonBody.isIn(request)
                ? read(request, (reader, fields) -> reader.readGoOn(user, fields.number("stop")))
                : new MissionEvent.GoOn(user.name(), null));
  }

  /** A body is needed only where the load's place must be said. */
  public static void cancel(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(
        request,
        response,
        user ->
            JsonBody.isIn(request)
                ? read(request, (reader, fields) -> reader.readCancel(user, fields.text("load")))
                : new MissionEvent.Cancel(user.name(), null));
  }

  public static void answer(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(
        request,
        response,
        user -> read(request, (reader, fields) -> reader.readAnswer(user, fields.text("answer"))));
  }

  public static void moveLoad(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorMap floor = new Tasks(services(request)).floorOf(changeableTask(request));
    change(
        request,
        response,
        user -> read(request, (reader, fields) -> reader.readMove(user, fields, floor)));
  }

  public static void removeLoad(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(request, response, user -> new MissionEvent.RemoveLoad(user.name()));
  }

  /** Reads a command from the body, if it has one. */
  @FunctionalInterface
  private interface BodyReader {
    MissionEvent.OperatorCommand read(Caller user) throws IOException;
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, BodyReader body)
      throws IOException {
    change(request, response, changeableTask(request), body);
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, TaskView task, BodyReader body)
      throws IOException {
    Caller caller = Caller.of(request);
    MissionEvent.OperatorCommand command = body.read(caller);
    send(
        request,
        response,
        acceptedValue(
            request,
            FleetAnswers.await(services(request).fleet().commandTask(task.id(), command))));
  }

  private static MissionEvent.OperatorCommand read(
      HttpServletRequest request,
      BiFunction<TaskCommandReader, JsonFields, MissionEvent.OperatorCommand> reader)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    MissionEvent.OperatorCommand command =
        reader.apply(new TaskCommandReader(Texts.of(request), errors), fields);
    fields.refuseUnknown();
    throwIfAny(errors);
    return command;
  }

  private static TaskView changeableTask(HttpServletRequest request) {
    TaskView task = task(request);
    if (!TaskCommandReader.canChange(Caller.of(request), task)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourTask")).exception();
    }
    return task;
  }

  private static TaskView task(HttpServletRequest request) {
    return new Tasks(services(request))
        .task(RequestPath.number(request, "id"))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchTask")).exception());
  }

  private static void send(HttpServletRequest request, HttpServletResponse response, TaskView task)
      throws IOException {
    response.setHeader("ETag", Version.ofOrder(task).tag());
    Services services = services(request);
    Json.send(
        request,
        response,
        200,
        TaskJson.withHistory(
            task,
            services.traces().isFollowed(Caller.of(request).account().id(), task.id()),
            services.archive().history(task.id()),
            services
                .fleet()
                .snapshots()
                .latest()
                .negotiations()
                .getOrDefault(task.id(), List.of())));
  }
}
