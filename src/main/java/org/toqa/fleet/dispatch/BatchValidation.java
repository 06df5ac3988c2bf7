package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer.Rejection;
import org.toqa.fleet.TaskOrder;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * Checks many orders at once, each kind of them once. It waits for their paths, so that is done on
 * a thread of its own.
 *
 * @param capacity of all robots that there are
 * @param check of all of them together
 */
public record BatchValidation(
    OrderValidator validator,
    List<TaskOrder> orders,
    String user,
    Instant now,
    Capacity capacity,
    OrderChecks.Check check) {

  /**
   * @param tasks of the orders that are good; their ids are not known yet
   */
  public record Result(List<TransportTask> tasks, List<Rejection> rejections) {}

  /** Checks one order after the other. */
  CompletableFuture<Result> run() {
    List<TransportTask> tasks = new ArrayList<>();
    List<Rejection> rejections = new ArrayList<>();
    Map<TaskOrder, CompletableFuture<List<Answer<TransportTask>>>> known =
        new ConcurrentHashMap<>();
    CompletableFuture<Void> checked = CompletableFuture.completedFuture(null);
    for (int place = 0; place < orders.size(); place++) {
      int index = place;
      checked =
          checked.thenCompose(
              _ ->
                  known
                      .computeIfAbsent(orders.get(index), this::check)
                      .thenAccept(
                          answers ->
                              answers.forEach(answer -> add(answer, index, tasks, rejections))));
    }
    return checked.thenApply(_ -> new Result(tasks, rejections));
  }

  private CompletableFuture<List<Answer<TransportTask>>> check(TaskOrder order) {
    return validator.checkAll(order, user, now, capacity, check).toCompletableFuture();
  }

  private static void add(
      Answer<TransportTask> checked,
      int place,
      List<TransportTask> tasks,
      List<Rejection> rejections) {
    switch (checked) {
      case Answer.Accepted<TransportTask>(TransportTask task) -> tasks.add(task);
      case Answer.Rejected<TransportTask>(String field, Sentence sentence) ->
          rejections.add(new Rejection(place, field, sentence));
      case Answer.Conflict<TransportTask>(Sentence sentence, var needs) ->
          rejections.add(new Rejection(place, null, sentence));
      case Answer.Outdated<TransportTask>() ->
          throw new IllegalStateException("A new task is not outdated.");
      case Answer.Unknown<TransportTask>(Sentence sentence) ->
          rejections.add(new Rejection(place, null, sentence));
    }
  }
}
