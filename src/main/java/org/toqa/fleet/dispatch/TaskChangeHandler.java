package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.concurrent.atomic.AtomicBoolean;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Edits what was ordered of tasks that wait, and deletes tasks that have ended.
 *
 * <ol>
 *   <li>What is ordered instead is checked as a new order is, by plans of other threads, and comes
 *       back as a message.
 *   <li>It is a command to the task then: one that has got robots meanwhile refuses it, and one
 *       that somebody else has edited meanwhile too.
 * </ol>
 */
final class TaskChangeHandler {
  private final DispatchState state;
  private final OrderValidator validator;
  private final StoreHealthCheck storeHealth;
  private final SnapshotPublisher snapshots;
  private final ActorRef<DispatchMessage> self;

  TaskChangeHandler(
      DispatchState state,
      OrderValidator validator,
      StoreHealthCheck storeHealth,
      SnapshotPublisher snapshots,
      ActorRef<DispatchMessage> self) {
    this.state = state;
    this.validator = validator;
    this.storeHealth = storeHealth;
    this.snapshots = snapshots;
    this.self = self;
  }

  void edit(DispatchMessage.EditTask m) {
    if (state.queue.get(m.task()).isEmpty()) {
      m.check().close();
      refuse(m.replyTo(), Phrase.TASK_WAITS_NO_MORE.with(m.task()));
      return;
    }
    var _ =
        validator
            .checkTask(m.order(), m.user(), state.clock.instant(), state.capacity(), m.check())
            .whenComplete(
                (checked, failure) -> {
                  m.check().close();
                  if (failure != null) {
                    m.replyTo().tell(StatusReply.error(failure));
                  } else if (checked
                      instanceof Answer.Accepted<TransportTask>(TransportTask order)) {
                    self.tell(new DispatchMessage.EditChecked(order, m));
                  } else {
                    m.replyTo().tell(StatusReply.success(checked.asRejection()));
                  }
                });
  }

  static DispatchMessage.CommandTask command(DispatchMessage.EditChecked m) {
    DispatchMessage.EditTask request = m.request();
    return new DispatchMessage.CommandTask(
        request.task(),
        new MissionEvent.Edit(request.user(), m.order(), request.seen()),
        request.replyTo());
  }

  void delete(DispatchMessage.DeleteTask m) {
    long task = m.task().id();
    OrderPart part = m.task().task().part();
    if (!storeHealth.isAvailable()) {
      m.replyTo().tell(StatusReply.error(TaskCommandHandler.away()));
    } else if (state.hasLoadOf(task)) {
      refuse(m.replyTo(), Phrase.LOAD_IS_STILL_THERE.with(task));
    } else if (part != null && state.isOrderOpen(part.order())) {
      refuse(m.replyTo(), Phrase.ORDER_HAS_NOT_ENDED.with(task, part.order()));
    } else if (state.queue.get(task).isPresent() || state.isOnFloor(task)) {
      refuse(m.replyTo(), Phrase.TASK_HAS_NOT_ENDED.with(task));
    } else {
      deleteStored(m);
    }
  }

  private void deleteStored(DispatchMessage.DeleteTask m) {
    long task = m.task().id();
    Instant at = state.clock.instant();
    EventRecord event =
        new EventRecord(
            at,
            EventKind.TASK_DELETED,
            task,
            null,
            m.user(),
            Phrase.TASK_DELETED.with(m.user(), Sentence.verbatim(m.task().task().name())));
    AtomicBoolean isDeleted = new AtomicBoolean();
    state.writer.tryOnce(
        () -> isDeleted.set(state.store.deleteTask(task, event)),
        () -> {
          if (isDeleted.get()) {
            self.tell(new DispatchMessage.TaskDeleted(m));
          } else { // it has ended, so it is gone
            m.replyTo()
                .tell(
                    StatusReply.success(
                        new Answer.Unknown<>(Phrase.TASK_WAS_DELETED_BEFORE.with(task))));
          }
        },
        failure ->
            m.replyTo()
                .tell(
                    StatusReply.error(failure.isRefusal() ? failure : TaskCommandHandler.away())));
  }

  /** Whoever asks after the answer finds it nowhere. */
  void deleted(DispatchMessage.DeleteTask m) {
    state.ended.removeIf(task -> task.id() == m.task().id());
    snapshots.publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.task())));
  }

  private static void refuse(ActorRef<StatusReply<Answer<TaskView>>> replyTo, Sentence sentence) {
    replyTo.tell(StatusReply.success(new Answer.Conflict<>(sentence, null)));
  }
}
