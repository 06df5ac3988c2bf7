package org.toqa.web;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.gateway.GatewayState;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.OrderPart;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.Trouble;
import org.toqa.persistence.StoreException;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Tasks in memory: it takes orders by the contract's rules, and finds tasks by state and text. */
public abstract class TasksInMemory extends ArchiveInMemory implements Fleet {
  /** Kilograms; what all robots together can carry. */
  private static final double HEAVIEST = 50;

  final FloorMap floor = Hall.floor();
  private final Function<String, @Nullable Long> accountId;
  private boolean silent;
  private boolean closed;
  private CheckRefusedException.@Nullable Reason refused;

  TasksInMemory(Function<String, @Nullable Long> accountId) {
    this.accountId = accountId;
  }

  /** From now on the store does not answer. */
  public void stopAnswering() {
    silent = true;
  }

  /** From now on who orders may not log in any more, as while he is deleted. */
  public void refuseOrderers() {
    closed = true;
  }

  /** From now on no order and no preview is checked to its end. */
  public void refuseChecks(CheckRefusedException.Reason reason) {
    refused = reason;
  }

  /** As before the first robot and the first task; only versions and the time go on. */
  void forgetAll() {
    lock.lock();
    try {
      forgetTasks();
      silent = false;
      closed = false;
      refused = null;
      forgetSnapshot();
    } finally {
      lock.unlock();
    }
  }

  /** Publishes another state of a task and records it. */
  public void changeTask(long id, TaskState state, List<String> robots, String sentence) {
    lock.lock();
    try {
      tasks.replaceAll(
          view ->
              view.id() == id
                  ? Views.task(
                      view.task(), state, false, robots, null, null, false, null, null, latest.at())
                  : view);
      events.add(
          new EventRecord(
              latest.at(), state.name(), id, null, "fleet", Sentence.verbatim(sentence)));
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  /** Publishes another view of a task. */
  public void changeView(long id, UnaryOperator<TaskView> change) {
    lock.lock();
    try {
      tasks.replaceAll(t -> t.id() == id ? change.apply(t) : t);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public boolean isSubmissionPending(UUID key) {
    return false;
  }

  @Override
  public List<Sentence> advice() {
    lock.lock();
    try {
      return advice;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<Sentence> failures() {
    lock.lock();
    try {
      return failures;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<TaskView>> submit(TaskOrder order, Orderer by, UUID key) {
    String user = by.name();
    if (refused != null) {
      return CompletableFuture.failedFuture(new CheckRefusedException(refused));
    }
    if (silent) {
      return CompletableFuture.failedFuture(new StoreException("no store", null));
    }
    if (closed) {
      return CompletableFuture.failedFuture(
          new StoreException(StoreException.Kind.UNKNOWN_USER, user, null));
    }
    lock.lock();
    try {
      Answer<TransportTask> checked = checked(order, user);
      if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
        return CompletableFuture.completedFuture(checked.asRejection());
      }
      TaskView view =
          Views.task(
              task,
              TaskState.QUEUED,
              false,
              List.of(),
              null,
              Phrase.LOOKING_FOR_ROBOT.with(),
              false,
              null,
              null,
              latest.at());
      tasks.add(view);
      nextId++;
      keys.put(key, view.id());
      events.add(
          new EventRecord(
              latest.at(), "QUEUED", task.id(), null, user, Phrase.ASKED_FOR_BY.with(user)));
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(view));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<BatchAnswer> submitAll(
      List<TaskOrder> orders, List<@Nullable OrderPart> parts, Orderer by, List<UUID> keys) {
    String user = by.name();
    if (refused != null) {
      return CompletableFuture.failedFuture(new CheckRefusedException(refused));
    }
    if (silent) {
      return CompletableFuture.failedFuture(new StoreException("no store", null));
    }
    if (closed) {
      return CompletableFuture.failedFuture(
          new StoreException(StoreException.Kind.UNKNOWN_USER, user, null));
    }
    lock.lock();
    try {
      List<BatchAnswer.Rejection> refusals = refusalsOf(orders, user);
      if (!refusals.isEmpty()) {
        return CompletableFuture.completedFuture(new BatchAnswer.Rejected(refusals));
      }
      List<TaskView> added = new ArrayList<>();
      long newOrder = nextId;
      for (int i = 0; i < orders.size(); i++) {
        submit(orders.get(i), by, keys.get(i));
        OrderPart part = parts.isEmpty() ? null : parts.get(i);
        if (part != null && part.position() == 1) {
          newOrder = nextId;
        }
        if (part != null) {
          setPart(part.order() == 0 ? part.withOrder(newOrder) : part);
        }
        added.add(tasks.getLast());
      }
      publish(latest.robots());
      return CompletableFuture.completedFuture(new BatchAnswer.Accepted(added));
    } finally {
      lock.unlock();
    }
  }

  /** The newest task is that part of an order. */
  private void setPart(OrderPart part) {
    TaskView view = tasks.removeLast();
    tasks.add(
        Views.task(
            view.task().withPart(part),
            view.state(),
            view.held(),
            view.robots(),
            view.loadAt(),
            view.waitingFor(),
            view.blocked(),
            view.needs(),
            view.late(),
            view.changedAt()));
  }

  @Override
  public CompletionStage<List<BatchAnswer.Rejection>> rejections(
      List<TaskOrder> orders, String user) {
    lock.lock();
    try {
      return CompletableFuture.completedFuture(refusalsOf(orders, user));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public <T> CompletionStage<T> decide(
      TaskOrder order, String user, Function<Optional<BatchAnswer.Rejection>, T> decision) {
    return rejections(List.of(order), user)
        .thenApply(found -> decision.apply(found.stream().findFirst()));
  }

  private List<BatchAnswer.Rejection> refusalsOf(List<TaskOrder> orders, String user) {
    List<BatchAnswer.Rejection> refusals = new ArrayList<>();
    for (int i = 0; i < orders.size(); i++) {
      for (Answer<TransportTask> answer : answers(orders.get(i), user)) {
        if (answer instanceof Answer.Rejected<TransportTask>(String field, Sentence sentence)) {
          refusals.add(new BatchAnswer.Rejection(i, field, sentence));
        }
      }
    }
    return refusals;
  }

  private Answer<TransportTask> checked(TaskOrder order, String user) {
    return answers(order, user).getFirst();
  }

  /** The task alone, or all that is against it. */
  private List<Answer<TransportTask>> answers(TaskOrder order, String user) {
    List<Optional<TaskPlace>> places = order.places().stream().map(this::place).toList();
    List<Answer<TransportTask>> answers = new ArrayList<>();
    if (order.floor() != null && !order.floor().equals(floor.name())) {
      answers.add(new Answer.Rejected<>("floor", Phrase.NO_SUCH_FLOOR.with(order.floor())));
    }
    if (order.load() > HEAVIEST) {
      answers.add(
          new Answer.Rejected<>("load", Phrase.TOO_HEAVY_TOGETHER.with(order.load(), HEAVIEST)));
    }
    List<String> fields =
        order.stops().isEmpty()
            ? List.of("start", "goal")
            : IntStream.range(0, places.size()).mapToObj(i -> "stops." + i).toList();
    for (int i = 0; i < places.size(); i++) {
      if (places.get(i).isEmpty()) {
        answers.add(notFree(fields.get(i)));
      }
    }
    if (answers.isEmpty()) {
      answers.add(
          new Answer.Accepted<>(
              order
                  .task(
                      places.stream().map(Optional::orElseThrow).toList(),
                      floor.name(),
                      user,
                      latest.at())
                  .withId(nextId)
                  .withOwner(user, accountId.apply(user))));
    }
    return answers;
  }

  private static Answer<TransportTask> notFree(String end) {
    return new Answer.Rejected<>(
        end,
        Sentence.verbatim(
            "The %s is not a free place of the floor. Choose another one.".formatted(end)));
  }

  /** Two carry it, straight from start to goal. */
  @Override
  public CompletionStage<Answer<TaskPreview>> preview(TaskOrder order, String user) {
    if (refused != null) {
      return CompletableFuture.failedFuture(new CheckRefusedException(refused));
    }
    lock.lock();
    try {
      Answer<TransportTask> checked = checked(order, user);
      return CompletableFuture.completedFuture(
          checked instanceof Answer.Accepted<TransportTask>(TransportTask task)
              ? new Answer.Accepted<>(
                  new TaskPreview(
                      2,
                      List.of("r1", "r2"),
                      Phrase.IS_SOONER.with(),
                      List.of(task.start().position(), task.goal().position())))
              : checked.asRejection());
    } finally {
      lock.unlock();
    }
  }

  /** Straight. */
  @Override
  public CompletionStage<Answer<PathAnswer>> path(PathQuestion question, String user) {
    TaskOrder order =
        new TaskOrder(
            "path", 1, question.start(), question.goal(), question.floor(), 0, null, null);
    return preview(order, user)
        .thenApply(
            answer ->
                answer instanceof Answer.Accepted<TaskPreview>(TaskPreview preview)
                    ? new Answer.Accepted<>(new PathAnswer(floor.name(), preview.path()))
                    : answer.asRejection());
  }

  /** Tasks are the mission of one robot, r1. */
  @Override
  public CompletionStage<Answer<TaskView>> commandTask(
      long id, MissionEvent.OperatorCommand command) {
    lock.lock();
    try {
      Mission mission = mission(task(id).orElseThrow());
      Optional<Objection> objection = mission.objectionTo(command);
      if (objection.isPresent()) {
        return CompletableFuture.completedFuture(Answer.conflict(objection.get()));
      }
      TaskView next = TaskView.of(mission.apply(command).mission(), null, latest.at());
      tasks.replaceAll(view -> view.id() == id ? next : view);
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(next));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<TaskView>> editTask(
      long id, TaskOrder order, @Nullable TransportTask seen, String user) {
    lock.lock();
    try {
      Answer<TransportTask> checked = checked(order, user);
      if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask ordered))) {
        return CompletableFuture.completedFuture(checked.asRejection());
      }
      MissionEvent.Edit edit = new MissionEvent.Edit(user, ordered, seen);
      return mission(task(id).orElseThrow()).isOutdated(edit)
          ? CompletableFuture.completedFuture(new Answer.Outdated<>())
          : commandTask(id, edit);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public CompletionStage<Answer<TaskView>> deleteTask(TaskView task, String user) {
    lock.lock();
    try {
      if (!task.state().isEnded()) {
        return CompletableFuture.completedFuture(
            new Answer.Conflict<>(Phrase.TASK_HAS_NOT_ENDED.with(task.id()), null));
      }
      tasks.removeIf(t -> t.id() == task.id());
      publish(latest.robots());
      return CompletableFuture.completedFuture(new Answer.Accepted<>(task));
    } finally {
      lock.unlock();
    }
  }

  private static Mission mission(TaskView view) {
    Phase phase = view.state() == TaskState.CARRYING ? Phase.TO_GOAL : Phase.TO_OBJECT;
    List<AssignedRobot> carriers =
        view.robots().stream().map(robot -> new AssignedRobot(robot, phase, false, false)).toList();
    Trouble trouble =
        view.needs() == null
            ? null
            : new Trouble(
                "r1", Phrase.IS_NOT_HEARD_OF.with(), new TaskPlace(new Vec2(2, 2), null), false);
    TaskPlace left = view.state().isEnded() ? view.loadAt() : null;
    return new Mission(
        view.task(),
        view.state(),
        carriers,
        view.held(),
        null,
        left,
        trouble,
        view.load(),
        view.progress());
  }

  /** r1 has come to that stop of the task's, from 0, and waits there. */
  public void waitAtStop(long id, int stop) {
    changeView(
        id,
        view -> {
          Mission mission =
              Mission.queued(view.task())
                  .assign(List.of("r1"), Phrase.IS_SOONER.with())
                  .mission()
                  .apply(new MissionEvent.PhaseEnded("r1", Phase.TO_OBJECT, 0, latest.at()))
                  .mission();
          for (int next = 1; next <= stop; next++) {
            mission =
                mission
                    .apply(new MissionEvent.PhaseEnded("r1", Phase.TO_GOAL, next, latest.at()))
                    .mission();
          }
          return TaskView.of(mission, null, latest.at());
        });
  }

  /** Publishes that a robot of the task, which has the load on board, is lost. */
  public void loseRobotOf(long id) {
    lock.lock();
    try {
      MissionEvent lost = new MissionEvent.RobotLost("r1", new TaskPlace(new Vec2(2, 2), null));
      tasks.replaceAll(
          view ->
              view.id() == id
                  ? TaskView.of(mission(view).apply(lost).mission(), null, latest.at())
                  : view);
      publish(latest.robots());
    } finally {
      lock.unlock();
    }
  }

  private Optional<TaskPlace> place(Where where) {
    return switch (where) {
      case Where.Point(Vec2 position) ->
          Optional.of(new TaskPlace(position, null)).filter(p -> floor.grid().isFree(p.position()));
      case Where.Station(String name) ->
          floor.place(name).map(p -> new TaskPlace(p.position(), p.name()));
      case Where.Charger(String name) ->
          floor.charging().stream()
              .filter(p -> name == null || p.name().equals(name))
              .findFirst()
              .map(p -> new TaskPlace(p.position(), null));
    };
  }

  @Override
  public List<GatewayState> gateways() {
    return List.of();
  }
}
