package org.toqa.fleet.dispatch;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.allocation.AllocationMethod;
import org.toqa.allocation.Policy;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * How the floor's rounds are held: as a manager has chosen, else as the configuration says. A
 * choice is stored before it counts, from the next round on.
 */
final class AllocatorChoice {
  private final DispatchState state;
  private final AllocationMethod configured;
  private final ActorRef<DispatchMessage> self;
  private Optional<Policy> chosen;

  /** The chosen one's; it keeps what its rounds learn. */
  private AllocationMethod method;

  AllocatorChoice(
      DispatchState state, AllocationMethod configured, ActorRef<DispatchMessage> self) {
    this.state = state;
    this.configured = configured;
    this.self = self;
    String word = state.store.floorAllocators().get(state.floor.name());
    this.chosen = Optional.ofNullable(word).flatMap(Policy::ofWord);
    this.method = chosen.map(Policy::method).orElse(configured);
  }

  AllocationMethod method() {
    return method;
  }

  /** The word of the one that a manager has chosen. */
  Optional<String> word() {
    return chosen.map(Policy::word);
  }

  void choose(DispatchMessage.ChooseAllocator m) {
    Optional<Policy> policy = m.allocator().flatMap(Policy::ofWord);
    if (m.allocator().isPresent() && policy.isEmpty()) {
      List<String> words = Arrays.stream(Policy.values()).map(Policy::word).toList();
      Sentence why = Phrase.NO_SUCH_ALLOCATOR.with(Sentence.names(words));
      m.replyTo().tell(StatusReply.success(new Answer.Rejected<>("allocator", why)));
      return;
    }
    String floor = state.floor.name();
    String word = policy.map(Policy::word).orElse(null);
    Sentence text =
        word == null
            ? Phrase.ALLOCATOR_AS_CONFIGURED.with(m.user(), floor)
            : Phrase.ALLOCATOR_CHOSEN.with(m.user(), word, floor);
    EventRecord event =
        new EventRecord(
                state.clock.instant(), EventKind.FLOOR_ALLOCATOR, null, null, m.user(), text)
            .onFloor(floor);
    state.writer.tryOnce(
        () -> state.store.saveFloorAllocator(floor, word, List.of(event)),
        () -> self.tell(new DispatchMessage.AllocatorStored(m)),
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  /** It is safe: let it count. */
  void stored(DispatchMessage.ChooseAllocator m) {
    chosen = m.allocator().flatMap(Policy::ofWord);
    method = chosen.map(Policy::method).orElse(configured);
    state.isRoundDue = true;
  }
}
