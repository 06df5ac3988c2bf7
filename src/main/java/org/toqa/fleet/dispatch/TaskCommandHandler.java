package org.toqa.fleet.dispatch;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.IntStream;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.allocation.AllocationProblem;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;

/**
 * Handles orders and commands of tasks: checks them, stores them, and puts tasks into the queue.
 *
 * <ol>
 *   <li>An order is checked, by plans of other threads, and comes back as a message.
 *   <li>It is adopted if the fleet is still strong enough for it, and checked again otherwise.
 *   <li>It is stored, and comes back as a message; then its caller is answered.
 * </ol>
 */
final class TaskCommandHandler {
  private final DispatchState state;
  private final AllocationRounds rounds;
  private final LateTaskReporter lateTasks;
  private final StoreHealthCheck storeHealth;
  private final OrderValidator validator;
  private final RoundDecider decider;
  private final ActorRef<DispatchMessage> self;
  private final TaskSubmitter submitter;
  private final PathQuery paths;
  private final SnapshotPublisher snapshots;
  private final PendingOrders pendingOrders = new PendingOrders();

  TaskCommandHandler(
      DispatchState state,
      AllocationRounds rounds,
      LateTaskReporter lateTasks,
      StoreHealthCheck storeHealth,
      OrderValidator validator,
      RoundDecider decider,
      PathQuery paths,
      SnapshotPublisher snapshots,
      PendingSubmissions pendingSubmissions,
      ActorRef<DispatchMessage> self) {
    this.state = state;
    this.rounds = rounds;
    this.lateTasks = lateTasks;
    this.storeHealth = storeHealth;
    this.validator = validator;
    this.decider = decider;
    this.paths = paths;
    this.snapshots = snapshots;
    this.self = self;
    this.submitter =
        new TaskSubmitter(state.store, state.writer, pendingSubmissions, state.runtime::nanoTime);
  }

  void submitTask(DispatchMessage.SubmitTask m) {
    CompletionStage<Answer<TransportTask>> check;
    try {
      check = checkOrder(m.order(), m.by().name(), m.check());
    } catch (RuntimeException e) { // it holds up no later order
      m.replyTo().tell(StatusReply.error(e));
      throw e;
    }
    PendingOrders.Pending pending = pendingOrders.add(m);
    var _ =
        check.whenComplete(
            (checked, failure) -> {
              m.check().close();
              self.tell(new DispatchMessage.OrderChecked(pending, checked, failure));
            });
  }

  private CompletionStage<Answer<TransportTask>> checkOrder(
      TaskOrder order, String user, OrderChecks.Check check) {
    return validator.checkTask(order, user, state.clock.instant(), state.capacity(), check);
  }

  /** Adopts all orders of its user that are checked and before which none waits for its check. */
  void orderChecked(DispatchMessage.OrderChecked m) {
    pendingOrders.setResult(m);
    String user = m.order().request().by().name();
    for (DispatchMessage.OrderChecked next = pendingOrders.pollChecked(user);
        next != null;
        next = pendingOrders.pollChecked(user)) {
      adopt(next);
    }
  }

  private void adopt(DispatchMessage.OrderChecked m) {
    DispatchMessage.SubmitTask request = m.order().request();
    Answer<TransportTask> checked = m.checked();
    if (checked == null) {
      request.replyTo().tell(StatusReply.error(requireNonNull(m.failure())));
    } else if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
      request.replyTo().tell(StatusReply.success(checked.asRejection()));
    } else if (!state.capacity().isEnoughFor(task)) {
      submitTask(request);
    } else {
      store(task, request);
    }
  }

  void submitTasks(DispatchMessage.SubmitTasks m) {
    if (!storeHealth.isAvailable()) {
      reject(m.replyTo(), away());
      return;
    }
    check(m);
  }

  private void check(DispatchMessage.SubmitTasks m) {
    var _ =
        checkConcurrently(m.orders(), m.by().name(), m.check())
            .whenComplete(
                (checked, failure) -> {
                  m.check().close();
                  if (failure == null) {
                    self.tell(new DispatchMessage.OrdersChecked(m, checked));
                  } else {
                    m.replyTo().tell(StatusReply.error(failure));
                  }
                });
  }

  void ordersChecked(DispatchMessage.OrdersChecked m) {
    DispatchMessage.SubmitTasks request = m.request();
    BatchValidation.Result checked = m.checked();
    if (!checked.rejections().isEmpty()) {
      request.replyTo().tell(StatusReply.success(new BatchAnswer.Rejected(checked.rejections())));
    } else if (!checked.tasks().stream().allMatch(state.capacity()::isEnoughFor)) {
      check(request);
    } else {
      submitter.submit(
          submissions(checked.tasks(), request),
          request.deadline(),
          stored -> self.tell(new DispatchMessage.TasksStored(stored, request.replyTo())),
          failure -> reject(request.replyTo(), failure));
    }
  }

  void checkOrders(DispatchMessage.CheckOrders m) {
    var _ =
        checkConcurrently(m.orders(), m.user(), m.check())
            .whenComplete(
                (checked, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(checked)
                                : StatusReply.error(failure)));
  }

  private CompletableFuture<BatchValidation.Result> checkConcurrently(
      List<TaskOrder> orders, String user, OrderChecks.Check check) {
    BatchValidation batch =
        new BatchValidation(
            validator, orders, user, state.clock.instant(), state.capacity(), check);
    return CompletableFuture.completedFuture(null)
        .thenComposeAsync(_ -> batch.run(), state.runtime.threadPerTaskExecutor("batch"));
  }

  private static List<Submission> submissions(
      List<TransportTask> tasks, DispatchMessage.SubmitTasks request) {
    return IntStream.range(0, tasks.size())
        .mapToObj(
            i ->
                Submission.of(
                    tasks.get(i), request.parts(), i, request.by(), request.idempotencyKeys()))
        .toList();
  }

  void findPath(DispatchMessage.FindPath m) {
    var _ =
        validator
            .findPath(m.question(), m.check())
            .whenComplete(
                (answer, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(answer)
                                : StatusReply.error(failure)));
  }

  void previewTask(DispatchMessage.PreviewTask m) {
    var _ =
        checkOrder(m.order(), m.user(), m.check())
            .whenComplete(
                (checked, failure) -> {
                  if (failure != null) {
                    m.replyTo().tell(StatusReply.error(failure));
                  } else if (checked
                      instanceof Answer.Accepted<TransportTask>(TransportTask task)) {
                    self.tell(new DispatchMessage.PreviewOrderChecked(task, m));
                  } else {
                    m.replyTo().tell(StatusReply.success(checked.asRejection()));
                  }
                });
  }

  void previewOrderChecked(DispatchMessage.PreviewOrderChecked m) {
    TransportTask task = m.task();
    DispatchMessage.PreviewTask request = m.request();
    if (!state.capacity().isEnoughFor(task)) {
      previewTask(request);
      return;
    }
    AllocationProblem problem =
        rounds.problem(
            List.of(rounds.restricted(TaskQueue.job(task, task.start(), StopProgress.START), task)),
            List.of(),
            state.candidates());
    var _ =
        new TaskPreviewer(decider, paths, state.floor, request.check())
            .preview(state.chosen().named(task), problem, state.now)
            .whenComplete(
                (preview, failure) ->
                    request
                        .replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(new Answer.Accepted<>(preview))
                                : StatusReply.error(failure)));
  }

  private void store(TransportTask task, DispatchMessage.SubmitTask request) {
    ActorRef<StatusReply<Answer<TaskView>>> replyTo = request.replyTo();
    if (!storeHealth.isAvailable()) {
      reject(replyTo, away());
      return;
    }
    submitter.submit(
        List.of(Submission.of(task, request.by(), request.idempotencyKey())),
        request.deadline(),
        stored -> self.tell(new DispatchMessage.TaskStored(stored.getFirst(), replyTo)),
        failure -> reject(replyTo, failure));
  }

  private static <T> void reject(ActorRef<StatusReply<T>> replyTo, StoreException failure) {
    replyTo.tell(StatusReply.error(failure.isRefusal() ? failure : away()));
  }

  static StoreException away() {
    return new StoreException(
        "The database does not answer, so nothing was accepted; try again.", null);
  }

  void taskStored(DispatchMessage.TaskStored m) {
    lateTasks.checkQueued(
        enqueue(List.of(m.task())),
        tasks -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(tasks.getFirst()))));
  }

  void tasksStored(DispatchMessage.TasksStored m) {
    lateTasks.checkQueued(
        enqueue(m.tasks()),
        tasks -> m.replyTo().tell(StatusReply.success(new BatchAnswer.Accepted(tasks))));
  }

  private List<TaskView> enqueue(List<TransportTask> tasks) {
    List<TaskView> views = new ArrayList<>();
    for (TransportTask task : tasks) {
      state.enqueue(Mission.queued(task), task.createdAt());
    }
    for (TransportTask task : tasks) { // a leg says what it waits for
      views.add(state.view(task.id(), DispatchState.LOOKING_FOR_ROBOT));
    }
    state.changed = true;
    return views;
  }

  /** A task that has robots is its floor's; the floor hands back what it does not have. */
  void commandTask(DispatchMessage.CommandTask m) {
    Optional<TaskQueue.Queued> queued = state.queue.get(m.task());
    if (queued.isPresent()) {
      commandTask(queued.get(), m);
      return;
    }
    if (state.report == null || state.isOnFloor(m.task())) {
      state.floorAgent.tell(new FloorMessage.CommandTask(m.task(), m.command(), m.replyTo()));
    } else {
      m.replyTo()
          .tell(
              StatusReply.success(
                  new Answer.Conflict<>(Phrase.TASK_HAS_ENDED.with(m.task()), null)));
    }
  }

  private void commandTask(TaskQueue.Queued queued, DispatchMessage.CommandTask m) {
    if (queued.mission().isOutdated(m.command())) {
      m.replyTo().tell(StatusReply.success(new Answer.Outdated<>()));
      return;
    }
    Optional<Objection> objection =
        queued
            .mission()
            .objectionTo(m.command())
            .or(() -> state.legs.objectionTo(m.command(), queued.mission()));
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission.Step step = queued.mission().apply(m.command());
    Instant at = state.clock.instant();
    Mission mission = step.mission();
    TaskView next;
    if (mission.state().isEnded()) {
      state.queue.remove(m.task());
      next = TaskView.of(mission, null, at);
      state.addEnded(next);
    } else {
      state.queue.add(mission, queued.since(), !step.hasChanges() && queued.stored());
      next = state.view(m.task(), DispatchState.LOOKING_FOR_ROBOT);
    }
    if (m.command() instanceof MissionEvent.Edit && step.hasChanges()) {
      rounds.taskEdited(queued.task());
      lateTasks.taskEdited(m.task());
    }
    state.changed = true;
    state.writer.write(
        () -> {
          if (step.hasChanges()) {
            state.store.saveMission(mission, at, EventRecord.of(step, m.command(), at));
          }
        },
        () -> {
          if (step.hasChanges()) {
            self.tell(new DispatchMessage.TaskCommandStored(m, mission, at, next));
          } else {
            m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(next)));
          }
        },
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  /** Whoever looks after the answer finds what he commanded. */
  void taskCommandStored(DispatchMessage.TaskCommandStored m) {
    take(m.mission(), m.at());
    snapshots.publish();
    m.request().replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.view())));
  }

  private void take(Mission mission, Instant at) {
    if (mission.leftLoad().isPresent()) {
      state.floorAgent.tell(new FloorMessage.LoadLeft(mission, at));
    }
    state
        .queue
        .get(mission.id())
        .filter(queued -> queued.mission().equals(mission))
        .ifPresent(queued -> state.queue.add(mission, queued.since(), true));
    state.isRoundDue = true;
  }
}
