package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.web.FieldErrors;
import org.toqa.web.Submissions;
import org.toqa.web.TaskListing;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** The tasks, all of them or some, and new ones. */
public final class TasksServlet extends ApiServlet {
  private static final int USUAL_LIMIT = 50;
  private static final int HIGHEST_LIMIT = 500;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    int offset = queryNumber(request, "offset", 0, 0, Integer.MAX_VALUE);
    int limit = queryNumber(request, "limit", USUAL_LIMIT, 1, HIGHEST_LIMIT);
    FieldErrors errors = new FieldErrors();
    TaskListing wanted = new TaskListing(request, errors);
    Filter filter = wanted.filter();
    Sort sort = wanted.sort();
    refuseIfAny(errors);
    Tasks tasks = new Tasks(services());
    response.setHeader("X-Total-Count", Long.toString(tasks.count(filter)));
    Json.send(
        request,
        response,
        200,
        tasks.list(filter, sort, offset, limit).stream().map(TaskJson::of).toList());
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskOrder order = TaskOrderJson.read(request);
    TaskView task =
        switch (services()
            .submissions()
            .submit(order, Caller.of(request).account(), IdempotencyKey.of(request))) {
          case Submissions.Outcome.Answered(var answer) -> accepted(request, answer);
          case Submissions.Outcome.Repeated(TaskView before) ->
              new Tasks(services()).byId(before.id()).orElse(before);
          case Submissions.Outcome.OtherOrder() ->
              throw Problem.of(422, Texts.of(request).get("problem.idempotencyKey.used")).raised();
        };
    response.setHeader("Location", request.getContextPath() + "/api/v1/tasks/" + task.id());
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        TaskJson.withHistory(task, List.of(EventRecord.added(task.task()))));
  }
}
