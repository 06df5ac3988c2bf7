package org.toqa.fleet.manager;

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
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationProblem;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.grid.FloorMap;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.OrderPart;
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
  private final FleetState fleet;
  private final AllocationRounds rounds;
  private final LateTaskReporter lateTasks;
  private final StoreHealthCheck storeHealth;
  private final OrderValidator validator;
  private final RoundDecider decider;
  private final ActorRef<ManagerMessage> self;
  private final TaskSubmitter submitter;
  private final PathQuery paths;
  private final SnapshotPublisher snapshots;
  private final PendingOrders pendingOrders = new PendingOrders();

  TaskCommandHandler(
      FleetState fleet,
      AllocationRounds rounds,
      LateTaskReporter lateTasks,
      StoreHealthCheck storeHealth,
      OrderValidator validator,
      RoundDecider decider,
      PathQuery paths,
      SnapshotPublisher snapshots,
      PendingSubmissions pendingSubmissions,
      ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
    this.rounds = rounds;
    this.lateTasks = lateTasks;
    this.storeHealth = storeHealth;
    this.validator = validator;
    this.decider = decider;
    this.paths = paths;
    this.snapshots = snapshots;
    this.self = self;
    this.submitter =
        new TaskSubmitter(fleet.store, fleet.writer, pendingSubmissions, fleet.runtime::nanoTime);
  }

  void submitTask(ManagerMessage.SubmitTask m) {
    CompletionStage<Answer<TransportTask>> check;
    try {
      check = checkOrder(m.order(), m.user(), m.check());
    } catch (RuntimeException e) { // it holds up no later order
      m.replyTo().tell(StatusReply.error(e));
      throw e;
    }
    PendingOrders.Pending pending = pendingOrders.add(m);
    var _ =
        check.whenComplete(
            (checked, failure) -> {
              m.check().close();
              self.tell(new ManagerMessage.OrderChecked(pending, checked, failure));
            });
  }

  private CompletionStage<Answer<TransportTask>> checkOrder(
      TaskOrder order, String user, OrderChecks.Check check) {
    return validator.checkTask(order, user, fleet.clock.instant(), fleet.capacity(), check);
  }

  /** Adopts all orders of its user that are checked and before which none waits for its check. */
  void orderChecked(ManagerMessage.OrderChecked m) {
    pendingOrders.setResult(m);
    String user = m.order().request().user();
    for (ManagerMessage.OrderChecked next = pendingOrders.pollChecked(user);
        next != null;
        next = pendingOrders.pollChecked(user)) {
      adopt(next);
    }
  }

  private void adopt(ManagerMessage.OrderChecked m) {
    ManagerMessage.SubmitTask request = m.order().request();
    Answer<TransportTask> checked = m.checked();
    if (checked == null) {
      request.replyTo().tell(StatusReply.error(requireNonNull(m.failure())));
    } else if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
      request.replyTo().tell(StatusReply.success(checked.asRejection()));
    } else if (task.load() > fleet.totalCapacity()) {
      submitTask(request);
    } else {
      store(task, request);
    }
  }

  void submitTasks(ManagerMessage.SubmitTasks m) {
    if (!storeHealth.isAvailable()) {
      reject(m.replyTo(), away());
      return;
    }
    check(m);
  }

  private void check(ManagerMessage.SubmitTasks m) {
    var _ =
        checkConcurrently(m.orders(), m.user(), m.check())
            .whenComplete(
                (checked, failure) -> {
                  m.check().close();
                  if (failure == null) {
                    self.tell(new ManagerMessage.OrdersChecked(m, checked));
                  } else {
                    m.replyTo().tell(StatusReply.error(failure));
                  }
                });
  }

  void ordersChecked(ManagerMessage.OrdersChecked m) {
    ManagerMessage.SubmitTasks request = m.request();
    BatchValidation.Result checked = m.checked();
    if (!checked.rejections().isEmpty()) {
      request.replyTo().tell(StatusReply.success(new BatchAnswer.Rejected(checked.rejections())));
    } else if (checked.heaviestLoad() > fleet.totalCapacity()) {
      check(request);
    } else {
      submitter.submit(
          submissions(checked.tasks(), request),
          request.deadline(),
          stored -> self.tell(new ManagerMessage.TasksStored(stored, request.replyTo())),
          failure -> reject(request.replyTo(), failure));
    }
  }

  void validateOrders(ManagerMessage.ValidateOrders m) {
    var _ =
        checkConcurrently(m.orders(), m.user(), m.check())
            .whenComplete(
                (checked, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(checked.rejections())
                                : StatusReply.error(failure)));
  }

  private CompletableFuture<BatchValidation.Result> checkConcurrently(
      List<TaskOrder> orders, String user, OrderChecks.Check check) {
    BatchValidation batch =
        new BatchValidation(
            validator, orders, user, fleet.clock.instant(), fleet.capacity(), check);
    return CompletableFuture.completedFuture(null)
        .thenComposeAsync(_ -> batch.run(), fleet.runtime.threadPerTaskExecutor("batch"));
  }

  private static List<Submission> submissions(
      List<TransportTask> tasks, ManagerMessage.SubmitTasks request) {
    List<@Nullable OrderPart> parts = request.parts();
    return IntStream.range(0, tasks.size())
        .mapToObj(
            i ->
                new Submission(
                    parts.isEmpty() ? tasks.get(i) : tasks.get(i).withPart(parts.get(i)),
                    request.idempotencyKeys().get(i)))
        .toList();
  }

  void findPath(ManagerMessage.FindPath m) {
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

  void previewTask(ManagerMessage.PreviewTask m) {
    var _ =
        checkOrder(m.order(), m.user(), m.check())
            .whenComplete(
                (checked, failure) -> {
                  if (failure != null) {
                    m.replyTo().tell(StatusReply.error(failure));
                  } else if (checked
                      instanceof Answer.Accepted<TransportTask>(TransportTask task)) {
                    self.tell(new ManagerMessage.PreviewOrderChecked(task, m));
                  } else {
                    m.replyTo().tell(StatusReply.success(checked.asRejection()));
                  }
                });
  }

  void previewOrderChecked(ManagerMessage.PreviewOrderChecked m) {
    TransportTask task = m.task();
    ManagerMessage.PreviewTask request = m.request();
    if (task.load() > fleet.totalCapacity()) {
      previewTask(request);
      return;
    }
    FloorMap floor = requireNonNull(fleet.floorMaps.get(task.floor()));
    AllocationProblem problem =
        rounds.problem(
            floor,
            List.of(TaskQueue.job(task, task.start())),
            List.of(),
            fleet.candidates(floor.name()));
    var _ =
        new TaskPreviewer(decider, paths, floor, request.check())
            .preview(task, problem, fleet.now)
            .whenComplete(
                (preview, failure) ->
                    request
                        .replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(new Answer.Accepted<>(preview))
                                : StatusReply.error(failure)));
  }

  private void store(TransportTask task, ManagerMessage.SubmitTask request) {
    ActorRef<StatusReply<Answer<TaskView>>> replyTo = request.replyTo();
    if (!storeHealth.isAvailable()) {
      reject(replyTo, away());
      return;
    }
    submitter.submit(
        List.of(new Submission(task, request.idempotencyKey())),
        request.deadline(),
        stored -> self.tell(new ManagerMessage.TaskStored(stored.getFirst(), replyTo)),
        failure -> reject(replyTo, failure));
  }

  private static <T> void reject(ActorRef<StatusReply<T>> replyTo, StoreException failure) {
    replyTo.tell(StatusReply.error(failure.isRefusal() ? failure : away()));
  }

  static StoreException away() {
    return new StoreException(
        "The database does not answer, so nothing was accepted; try again.", null);
  }

  void taskStored(ManagerMessage.TaskStored m) {
    lateTasks.checkQueued(
        enqueue(List.of(m.task())),
        tasks -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(tasks.getFirst()))));
  }

  void tasksStored(ManagerMessage.TasksStored m) {
    lateTasks.checkQueued(
        enqueue(m.tasks()),
        tasks -> m.replyTo().tell(StatusReply.success(new BatchAnswer.Accepted(tasks))));
  }

  private List<TaskView> enqueue(List<TransportTask> tasks) {
    List<TaskView> views = new ArrayList<>();
    for (TransportTask task : tasks) {
      fleet.enqueue(Mission.queued(task), task.createdAt());
    }
    for (TransportTask task : tasks) { // a leg says what it waits for
      views.add(fleet.view(task.id(), FleetState.LOOKING_FOR_ROBOT));
    }
    fleet.changed = true;
    return views;
  }

  /** A task that has robots is its floor's; the floor hands back what it does not have. */
  void commandTask(ManagerMessage.CommandTask m) {
    Optional<TaskQueue.Queued> queued = fleet.queue.get(m.task());
    if (queued.isPresent()) {
      commandTask(queued.get(), m);
      return;
    }
    fleet
        .floorOf(m.task())
        .flatMap(fleet::floorAgent)
        .ifPresentOrElse(
            floor -> floor.tell(new FloorMessage.CommandTask(m.task(), m.command(), m.replyTo())),
            () ->
                m.replyTo()
                    .tell(
                        StatusReply.success(
                            new Answer.Conflict<>(Phrase.TASK_HAS_ENDED.with(m.task()), null))));
  }

  private void commandTask(TaskQueue.Queued queued, ManagerMessage.CommandTask m) {
    if (queued.mission().isOutdated(m.command())) {
      m.replyTo().tell(StatusReply.success(new Answer.Outdated<>()));
      return;
    }
    Optional<Objection> objection =
        queued
            .mission()
            .objectionTo(m.command())
            .or(() -> fleet.legs.objectionTo(m.command(), queued.mission()));
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission.Step step = queued.mission().apply(m.command());
    Instant at = fleet.clock.instant();
    Mission mission = step.mission();
    TaskView next;
    if (mission.state().isEnded()) {
      fleet.queue.remove(m.task());
      next = TaskView.of(mission, null, at);
      fleet.addEnded(next);
    } else {
      fleet.queue.add(mission, queued.since(), !step.hasChanges() && queued.stored());
      next = fleet.view(m.task(), FleetState.LOOKING_FOR_ROBOT);
    }
    if (m.command() instanceof MissionEvent.Edit && step.hasChanges()) {
      rounds.taskEdited(queued.task());
      lateTasks.taskEdited(m.task());
    }
    fleet.changed = true;
    fleet.writer.write(
        () -> {
          if (step.hasChanges()) {
            fleet.store.saveMission(mission, at, EventRecord.of(step, m.command(), at));
          }
        },
        () -> {
          if (step.hasChanges()) {
            self.tell(new ManagerMessage.TaskCommandStored(m, mission, at, next));
          } else {
            m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(next)));
          }
        },
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  /** Whoever looks after the answer finds what he commanded. */
  void taskCommandStored(ManagerMessage.TaskCommandStored m) {
    take(m.mission(), m.at());
    snapshots.publish();
    m.request().replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.view())));
  }

  private void take(Mission mission, Instant at) {
    if (mission.leftLoad().isPresent()) {
      fleet
          .floorAgent(mission.task().floor())
          .ifPresent(floor -> floor.tell(new FloorMessage.LoadLeft(mission, at)));
    }
    fleet
        .queue
        .get(mission.id())
        .filter(queued -> queued.mission().equals(mission))
        .ifPresent(queued -> fleet.queue.add(mission, queued.since(), true));
    fleet.dueFloors.add(mission.task().floor());
  }
}
