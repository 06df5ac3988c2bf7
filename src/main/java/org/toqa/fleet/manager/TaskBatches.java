package org.toqa.fleet.manager;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.BatchAnswer.Rejection;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.BatchValidation;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.dispatch.TaskSubmitter;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;

/**
 * Orders that are wanted together, of any floors: each is checked by its floor, all are stored in
 * one transaction or none, and each floor then takes its own.
 */
final class TaskBatches {
  private static final Executor DECISIONS = task -> Thread.ofVirtual().name("orders").start(task);

  private final FloorDirectory floors;
  private final TaskSubmitter submitter;

  /**
   * @param submitter stores what is of several floors
   */
  TaskBatches(FloorDirectory floors, TaskSubmitter submitter) {
    this.floors = floors;
    this.submitter = submitter;
  }

  /**
   * Those of one floor.
   *
   * @param places of the orders among all
   */
  private record Part(FloorEntry floor, List<Integer> places) {
    <T> List<T> of(List<T> all) {
      return places.stream().map(all::get).toList();
    }
  }

  /** The orders by their floors; empty where one names none that there is. */
  private Optional<List<Part>> parts(List<TaskOrder> orders) {
    Map<FloorEntry, List<Integer>> places = new LinkedHashMap<>();
    for (int i = 0; i < orders.size(); i++) {
      Optional<FloorEntry> floor = floors.resolve(orders.get(i));
      if (floor.isEmpty()) {
        return Optional.empty();
      }
      places.computeIfAbsent(floor.get(), _ -> new ArrayList<>()).add(i);
    }
    return Optional.of(
        places.entrySet().stream().map(e -> new Part(e.getKey(), e.getValue())).toList());
  }

  private List<Rejection> unknownFloors(List<TaskOrder> orders) {
    return IntStream.range(0, orders.size())
        .filter(i -> floors.resolve(orders.get(i)).isEmpty())
        .mapToObj(i -> new Rejection(i, "floor", floors.noSuchFloor(orders.get(i).floor())))
        .toList();
  }

  CompletionStage<List<Rejection>> rejections(List<TaskOrder> orders, String user) {
    Optional<List<Part>> parts = parts(orders);
    if (parts.isEmpty()) {
      return CompletableFuture.completedFuture(unknownFloors(orders));
    }
    return all(parts.get(), (floor, part) -> floor.rejections(part.of(orders), user))
        .thenApply(found -> merged(parts.get(), found));
  }

  /** As {@link org.toqa.fleet.Fleet#decide}. */
  <T> CompletionStage<T> decide(
      TaskOrder order, String user, Function<Optional<Rejection>, T> decision) {
    return floors
        .resolve(order)
        .map(
            floor ->
                FloorEntry.orIfRemoved(
                    floor.ask(agents -> decide(agents, order, user, decision)),
                    () -> decision.apply(unknownFloors(List.of(order)).stream().findFirst())))
        .orElseGet(
            () ->
                CompletableFuture.supplyAsync(
                    () -> decision.apply(unknownFloors(List.of(order)).stream().findFirst()),
                    DECISIONS));
  }

  private static <T> CompletionStage<T> decide(
      FloorFleet floor, TaskOrder order, String user, Function<Optional<Rejection>, T> decision) {
    return floor
        .rejections(List.of(order), user)
        .thenApplyAsync(found -> decision.apply(found.stream().findFirst()), DECISIONS);
  }

  /** With the places of their orders among all. */
  private static List<Rejection> merged(List<Part> parts, List<List<Rejection>> found) {
    return IntStream.range(0, parts.size())
        .boxed()
        .flatMap(
            i ->
                found.get(i).stream()
                    .map(
                        r ->
                            new Rejection(
                                parts.get(i).places().get(r.index()), r.field(), r.sentence())))
        .sorted(Comparator.comparingInt(Rejection::index))
        .toList();
  }

  CompletionStage<BatchAnswer> submit(
      List<TaskOrder> orders,
      List<@Nullable OrderPart> orderParts,
      Orderer by,
      List<UUID> keys,
      long deadline) {
    Optional<List<Part>> parts = parts(orders);
    if (parts.isEmpty()) {
      return CompletableFuture.completedFuture(new BatchAnswer.Rejected(unknownFloors(orders)));
    }
    if (parts.get().size() == 1) {
      return parts
          .get()
          .getFirst()
          .floor()
          .ask(floor -> floor.submitAll(orders, orderParts, by, keys));
    }
    return all(parts.get(), (floor, part) -> floor.check(part.of(orders), by.name()))
        .thenCompose(checked -> store(parts.get(), checked, orderParts, by, keys, deadline));
  }

  private CompletionStage<BatchAnswer> store(
      List<Part> parts,
      List<BatchValidation.Result> checked,
      List<@Nullable OrderPart> orderParts,
      Orderer by,
      List<UUID> keys,
      long deadline) {
    List<Rejection> rejections =
        merged(parts, checked.stream().map(BatchValidation.Result::rejections).toList());
    if (!rejections.isEmpty()) {
      return CompletableFuture.completedFuture(new BatchAnswer.Rejected(rejections));
    }
    @Nullable TransportTask[] tasks = new TransportTask[keys.size()];
    for (int i = 0; i < parts.size(); i++) {
      List<Integer> places = parts.get(i).places();
      for (int j = 0; j < places.size(); j++) {
        tasks[places.get(j)] = checked.get(i).tasks().get(j);
      }
    }
    List<Submission> submissions =
        IntStream.range(0, tasks.length)
            .mapToObj(i -> Submission.of(Objects.requireNonNull(tasks[i]), orderParts, i, by, keys))
            .toList();
    CompletableFuture<List<TransportTask>> stored = new CompletableFuture<>();
    submitter.submit(submissions, deadline, stored::complete, stored::completeExceptionally);
    return stored.thenCompose(all -> take(parts, all));
  }

  private static CompletionStage<BatchAnswer> take(List<Part> parts, List<TransportTask> stored) {
    return all(parts, (floor, part) -> floor.takeTasks(part.of(stored)))
        .thenApply(
            taken -> {
              @Nullable TaskView[] views = new TaskView[stored.size()];
              for (int i = 0; i < parts.size(); i++) {
                if (taken.get(i) instanceof BatchAnswer.Accepted(List<TaskView> tasks)) {
                  for (int j = 0; j < tasks.size(); j++) {
                    views[parts.get(i).places().get(j)] = tasks.get(j);
                  }
                }
              }
              return new BatchAnswer.Accepted(
                  Arrays.stream(views).map(Objects::requireNonNull).toList());
            });
  }

  private static <T> CompletionStage<List<T>> all(
      List<Part> parts, BiFunction<FloorFleet, Part, CompletionStage<T>> question) {
    List<CompletableFuture<T>> answers =
        parts.stream()
            .map(part -> part.floor().ask(f -> question.apply(f, part)).toCompletableFuture())
            .toList();
    return CompletableFuture.allOf(answers.toArray(CompletableFuture[]::new))
        .thenApply(_ -> answers.stream().map(CompletableFuture::join).toList());
  }
}
