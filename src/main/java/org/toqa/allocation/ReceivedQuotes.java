package org.toqa.allocation;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What robots' agents have said. Whoever has said nothing counts as silent. */
final class ReceivedQuotes implements Quotes {
  private final Costs map;

  /** By robot and task. */
  private final Map<String, Map<Long, Quote>> quotes = new HashMap<>();

  /** By robot that takes part no more, why. */
  private final Map<String, Quote> excluded = new HashMap<>();

  /**
   * @param map tells whether paths are wide enough
   */
  ReceivedQuotes(Costs map) {
    this.map = map;
  }

  void put(String robot, long task, Quote quote) {
    quotes.computeIfAbsent(robot, _ -> new HashMap<>()).put(task, quote);
  }

  /** From now on it answers so, whatever it is asked. */
  void exclude(String robot, Quote why) {
    excluded.put(robot, why);
  }

  boolean isExcluded(String robot) {
    return excluded.containsKey(robot);
  }

  Quote of(long task, String robot) {
    return Optional.ofNullable(excluded.get(robot))
        .orElseGet(() -> quotes.getOrDefault(robot, Map.of()).getOrDefault(task, Quote.SILENT));
  }

  @Override
  public List<Quote> of(AllocationTask task, List<Candidate> robots) {
    return robots.stream().map(robot -> of(task.id(), robot.robot())).toList();
  }

  @Override
  public boolean hasPathFor(AllocationTask task, Candidate robot) {
    return map.hasPathFor(task, robot);
  }
}
