package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskView;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OrderedTask;
import org.toqa.web.input.TaskQueryReader;

/** The tasks, all of them or some, and new ones. */
public final class TasksResource extends ApiHandler {
  private static final int DEFAULT_LIMIT = 50;
  private static final int MAX_LIMIT = 500;

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    int offset = queryNumber(request, "offset", 0, 0, Integer.MAX_VALUE);
    int limit = queryNumber(request, "limit", DEFAULT_LIMIT, 1, MAX_LIMIT);
    FieldErrors errors = new FieldErrors();
    TaskQueryReader query = new TaskQueryReader(request, errors);
    Filter filter = query.filter();
    Sort sort = query.sort();
    throwIfAny(errors);
    Tasks tasks = new Tasks(services(request));
    response.setHeader("X-Total-Count", Long.toString(tasks.count(filter)));
    Json.send(
        request,
        response,
        200,
        tasks.page(filter, sort, offset, limit).stream().map(TaskJson::of).toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    OrderedTask ordered = readBody(request, TemplatesResource.usable(request)::read);
    TaskView task =
        switch (services(request)
            .submitter()
            .submit(ordered.order(), Caller.of(request).account(), IdempotencyKey.of(request))) {
          case KeyedAnswer.Answered<TaskView>(var answer) ->
              acceptedValue(request, ordered.atEntered(answer));
          case KeyedAnswer.Repeated<TaskView>(TaskView before) ->
              new Tasks(services(request)).task(before.id()).orElse(before);
          case KeyedAnswer.KeyReused<TaskView>() ->
              throw Problem.of(422, Texts.of(request).get("problem.idempotencyKey.used"))
                  .exception();
        };
    response.setHeader("Location", request.getContextPath() + "/api/v1/tasks/" + task.id());
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        TaskJson.withHistory(task, false, List.of(EventRecord.added(task.task())), List.of()));
  }
}
