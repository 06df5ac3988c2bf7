package org.toqa.fleet.manager;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
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
 * How each floor's rounds are held: as a manager has chosen, else as the configuration says. A
 * choice is stored before it counts, from the next round on.
 */
final class FloorAllocators {
  private final FleetState fleet;
  private final AllocationMethod configured;
  private final ActorRef<ManagerMessage> self;

  /** By floor, where a manager has chosen. */
  private final Map<String, Policy> chosen = new TreeMap<>();

  private final Map<String, AllocationMethod> methods = new HashMap<>();

  FloorAllocators(FleetState fleet, AllocationMethod configured, ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
    this.configured = configured;
    this.self = self;
    fleet.store.floorAllocators().forEach((floor, word) -> apply(floor, Policy.ofWord(word)));
  }

  AllocationMethod method(String floor) {
    return methods.getOrDefault(floor, configured);
  }

  /** By floor, the words of those that a manager has chosen. */
  Map<String, String> words() {
    return chosen.entrySet().stream()
        .collect(Collectors.toMap(Map.Entry::getKey, entry -> entry.getValue().word()));
  }

  void choose(ManagerMessage.ChooseAllocator m) {
    if (!fleet.floors.containsKey(m.floor())) {
      m.replyTo()
          .tell(StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(m.floor()))));
      return;
    }
    Optional<Policy> policy = m.allocator().flatMap(Policy::ofWord);
    if (m.allocator().isPresent() && policy.isEmpty()) {
      List<String> words = Arrays.stream(Policy.values()).map(Policy::word).toList();
      Sentence why = Phrase.NO_SUCH_ALLOCATOR.with(Sentence.names(words));
      m.replyTo().tell(StatusReply.success(new Answer.Rejected<>("allocator", why)));
      return;
    }
    String word = policy.map(Policy::word).orElse(null);
    Sentence text =
        word == null
            ? Phrase.ALLOCATOR_AS_CONFIGURED.with(m.user(), m.floor())
            : Phrase.ALLOCATOR_CHOSEN.with(m.user(), word, m.floor());
    EventRecord event =
        new EventRecord(
            fleet.clock.instant(), EventKind.FLOOR_ALLOCATOR, null, null, m.user(), text);
    fleet.writer.tryOnce(
        () -> fleet.store.saveFloorAllocator(m.floor(), word, List.of(event)),
        () -> self.tell(new ManagerMessage.AllocatorStored(m)),
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  /** It is safe: let it count. */
  void stored(ManagerMessage.ChooseAllocator m) {
    apply(m.floor(), m.allocator().flatMap(Policy::ofWord));
    fleet.dueFloors.add(m.floor());
  }

  private void apply(String floor, Optional<Policy> policy) {
    chosen.remove(floor);
    methods.remove(floor);
    policy.ifPresent(
        known -> {
          chosen.put(floor, known);
          methods.put(floor, known.method());
        });
  }
}
