package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongPredicate;
import org.toqa.allocation.NegotiationLine;
import org.toqa.fleet.NegotiationEntry;

/** What was last said of tasks in negotiations. Confined to one agent. */
final class NegotiationLines {
  /** Of one task. */
  private static final int LINES_KEPT = 20;

  private final Map<Long, List<NegotiationEntry>> byTask = new HashMap<>();

  /**
   * @param later by how much the history's clock is ahead of the lines'
   */
  void add(List<NegotiationLine> lines, Duration later) {
    for (NegotiationLine line : lines) {
      List<NegotiationEntry> kept = new ArrayList<>(byTask.getOrDefault(line.task(), List.of()));
      kept.add(new NegotiationEntry(line.at().plus(later), line.text()));
      byTask.put(
          line.task(),
          List.copyOf(kept.subList(Math.max(0, kept.size() - LINES_KEPT), kept.size())));
    }
  }

  void retain(LongPredicate isKept) {
    byTask.keySet().removeIf(task -> !isKept.test(task));
  }

  /** By task, the oldest first. */
  Map<Long, List<NegotiationEntry>> byTask() {
    return Map.copyOf(byTask);
  }
}
