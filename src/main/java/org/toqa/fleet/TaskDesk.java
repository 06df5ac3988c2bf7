package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Situation;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.grid.FloorMap;
import org.toqa.mission.Mission;
import org.toqa.mission.Objection;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;

/** Takes what people want of tasks: checks it, stores it, and puts it into the queue. */
final class TaskDesk {
  private final FleetState fleet;
  private final AllocationRounds rounds;
  private final LateTasks late;
  private final StoreWatch storeWatch;
  private final OrderCheck check;
  private final Allocator allocator;
  private final ActorRef<ManagerMessage> self;
  private final TaskIntake intake;

  TaskDesk(
      FleetState fleet,
      AllocationRounds rounds,
      LateTasks late,
      StoreWatch storeWatch,
      OrderCheck check,
      Allocator allocator,
      ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
    this.rounds = rounds;
    this.late = late;
    this.storeWatch = storeWatch;
    this.check = check;
    this.allocator = allocator;
    this.self = self;
    this.intake = new TaskIntake(fleet.store, fleet.writer);
  }

  void submit(ManagerMessage.Submit m) {
    Answer<TransportTask> checked = checked(m.order(), m.user());
    if (checked instanceof Answer.Accepted<TransportTask>(TransportTask task)) {
      store(task, m.key(), m.replyTo());
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private Answer<TransportTask> checked(TaskOrder order, String user) {
    return check.task(order, user, fleet.clock.instant(), together());
  }

  /** What all robots carry together, kilograms. */
  private double together() {
    return fleet.robots.isEmpty()
        ? Double.MAX_VALUE
        : fleet.robots.values().stream().mapToDouble(RobotRecord::maxLoad).sum();
  }

  void submitAll(ManagerMessage.SubmitAll m) {
    if (!storeWatch.answers()) {
      refuse(m.replyTo());
      return;
    }
    long deadline = TaskIntake.deadline();
    var _ =
        checkApart(m.orders(), m.user())
            .whenComplete(
                (checked, failure) -> {
                  if (failure != null) {
                    m.replyTo().tell(StatusReply.error(failure));
                  } else if (!checked.refusals().isEmpty()) {
                    m.replyTo()
                        .tell(StatusReply.success(new BatchAnswer.Refused(checked.refusals())));
                  } else {
                    intake.take(
                        submissions(checked.tasks(), m.keys()),
                        deadline,
                        stored -> self.tell(new ManagerMessage.AllStored(stored, m.replyTo())),
                        () -> refuse(m.replyTo()));
                  }
                });
  }

  void checkAll(ManagerMessage.CheckAll m) {
    var _ =
        checkApart(m.orders(), m.user())
            .whenComplete(
                (checked, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(checked.refusals())
                                : StatusReply.error(failure)));
  }

  private CompletableFuture<BatchCheck.Result> checkApart(List<TaskOrder> orders, String user) {
    BatchCheck batch =
        new BatchCheck(check.another(), orders, user, fleet.clock.instant(), together());
    return CompletableFuture.supplyAsync(
        batch::run, work -> Thread.ofVirtual().name("batch").start(work));
  }

  private static List<Submission> submissions(List<TransportTask> tasks, List<UUID> keys) {
    return IntStream.range(0, tasks.size())
        .mapToObj(i -> new Submission(tasks.get(i), keys.get(i)))
        .toList();
  }

  void preview(ManagerMessage.PreviewTask m) {
    Answer<TransportTask> checked = checked(m.order(), m.user());
    if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
      return;
    }
    FloorMap floor = requireNonNull(fleet.maps.get(task.floor()));
    Situation situation =
        rounds.situation(
            floor,
            List.of(TaskQueue.job(task, task.start())),
            List.of(),
            fleet.candidates(floor.name()));
    var _ =
        CompletableFuture.supplyAsync(
                () -> new TaskForesight(allocator, floor).of(task, situation),
                work -> Thread.ofVirtual().name("preview").start(work))
            .whenComplete(
                (preview, failure) ->
                    m.replyTo()
                        .tell(
                            failure == null
                                ? StatusReply.success(new Answer.Accepted<>(preview))
                                : StatusReply.error(failure)));
  }

  private void store(
      TransportTask task, UUID key, ActorRef<StatusReply<Answer<TaskView>>> replyTo) {
    if (!storeWatch.answers()) {
      refuse(replyTo);
      return;
    }
    intake.take(
        List.of(new Submission(task, key)),
        TaskIntake.deadline(),
        stored -> self.tell(new ManagerMessage.TaskStored(stored.getFirst(), replyTo)),
        () -> refuse(replyTo));
  }

  private static <T> void refuse(ActorRef<StatusReply<T>> replyTo) {
    replyTo.tell(
        StatusReply.error(
            new StoreException(
                "The database does not answer, so nothing was accepted; try again.", null)));
  }

  void taskStored(ManagerMessage.TaskStored m) {
    Queueing queued = enqueue(List.of(m.task()));
    answer(queued, m.replyTo(), new Answer.Accepted<>(queued.tasks().getFirst()));
  }

  void allStored(ManagerMessage.AllStored m) {
    Queueing queued = enqueue(m.tasks());
    answer(queued, m.replyTo(), new BatchAnswer.Accepted(queued.tasks()));
  }

  /**
   * New tasks have come into the queue.
   *
   * @param late lines for the history of those that will be late
   */
  private record Queueing(List<TaskView> tasks, List<EventRecord> late) {}

  private Queueing enqueue(List<TransportTask> tasks) {
    List<TaskView> views = new ArrayList<>();
    List<EventRecord> told = new ArrayList<>();
    for (TransportTask task : tasks) {
      fleet.queue.add(Mission.queued(task), task.createdAt(), true);
      fleet.due.add(task.floor());
      TaskView queued = fleet.view(task.id(), FleetState.NOT_LOOKED_AT);
      late.look(queued).ifPresent(told::add);
      views.add(late.told(queued));
    }
    fleet.changed = true;
    return new Queueing(views, told);
  }

  private <T> void answer(Queueing queued, ActorRef<StatusReply<T>> replyTo, T answer) {
    if (queued.late().isEmpty()) {
      replyTo.tell(StatusReply.success(answer));
    } else {
      fleet.writer.write(
          () -> fleet.store.addEvents(queued.late()),
          () -> replyTo.tell(StatusReply.success(answer)));
    }
  }

  /** A task that has robots is its floor's; the floor hands back what it does not have. */
  void wished(ManagerMessage.Wished m) {
    Optional<TaskQueue.Queued> queued = fleet.queue.get(m.task());
    if (queued.isPresent()) {
      wished(queued.get(), m);
      return;
    }
    floorOf(m.task())
        .ifPresentOrElse(
            floor -> floor.tell(new FloorMessage.Wished(m.task(), m.wish(), m.replyTo())),
            () ->
                m.replyTo()
                    .tell(
                        StatusReply.success(
                            new Answer.Conflict<>(Phrase.TASK_HAS_ENDED.with(m.task()), null))));
  }

  private void wished(TaskQueue.Queued queued, ManagerMessage.Wished m) {
    Optional<Objection> objection = queued.mission().objectionTo(m.wish());
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    Mission.Step step = queued.mission().on(m.wish());
    Instant at = fleet.clock.instant();
    Mission mission = step.mission();
    TaskView next;
    if (mission.state().isEnded()) {
      fleet.queue.remove(m.task());
      next = TaskView.of(mission, null, at);
      fleet.shelve(next);
    } else {
      fleet.queue.add(mission, queued.since(), !step.changed() && queued.stored());
      next = fleet.view(m.task(), FleetState.NOT_LOOKED_AT);
    }
    fleet.changed = true;
    if (step.changed()) {
      fleet.writer.write(
          () -> fleet.store.saveMission(mission, at, EventRecord.of(step, m.wish(), at)),
          () -> self.tell(new ManagerMessage.WishStored(mission)));
    }
    fleet.writer.write(
        () -> {}, () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(next))));
  }

  void wishStored(Mission mission) {
    fleet
        .queue
        .get(mission.id())
        .filter(queued -> queued.mission().equals(mission))
        .ifPresent(queued -> fleet.queue.add(mission, queued.since(), true));
    fleet.due.add(mission.task().floor());
  }

  private Optional<ActorRef<FloorMessage>> floorOf(long task) {
    return Stream.concat(
            fleet.handedOver.values().stream(),
            fleet.reports.values().stream().flatMap(r -> r.missions().stream()))
        .filter(t -> t.id() == task)
        .findFirst()
        .flatMap(t -> fleet.floorAgent(t.task().floor()));
  }
}
