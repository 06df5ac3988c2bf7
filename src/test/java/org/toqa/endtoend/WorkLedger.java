package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import tools.jackson.databind.JsonNode;

/** What the server said to the work of one run, and whether all of that has come true. */
final class WorkLedger {

  /** What is known of something that was asked for. */
  enum Answer {
    ACCEPTED,
    REFUSED,
    /** The answer is lost: whether it was taken nobody knows. */
    UNKNOWN
  }

  /** By their names. */
  private final Map<String, Answer> tasks = new LinkedHashMap<>();

  /** By what the names of their tasks begin with. */
  private final Map<String, Answer> imports = new LinkedHashMap<>();

  /** By the names of their tasks. */
  private final Map<String, Answer> schedules = new LinkedHashMap<>();

  /** By task. */
  private final Map<Long, Answer> cancels = new HashMap<>();

  private final List<Long> ids = new ArrayList<>();
  private final int linesOfImport;

  WorkLedger(int linesOfImport) {
    this.linesOfImport = linesOfImport;
  }

  void addTask(String name, Answer answer) {
    tasks.put(name, answer);
  }

  /** One that was accepted. */
  void addTask(String name, long id) {
    tasks.put(name, Answer.ACCEPTED);
    ids.add(id);
  }

  void addImport(String beginning, Answer answer) {
    imports.put(beginning, answer);
  }

  void addSchedule(String task, Answer answer) {
    schedules.put(task, answer);
  }

  /**
   * What was once accepted stays so; and a second one is refused also where the first, whose answer
   * is not known, was taken.
   */
  void addCancel(long task, Answer answer) {
    cancels.merge(
        task,
        answer,
        (before, now) -> before == Answer.ACCEPTED || now == Answer.REFUSED ? before : now);
  }

  /** The tasks that may be cancelled: so it was asked, and not refused. */
  Set<Long> cancels() {
    return cancels.entrySet().stream()
        .filter(cancel -> cancel.getValue() != Answer.REFUSED)
        .map(Map.Entry::getKey)
        .collect(Collectors.toUnmodifiableSet());
  }

  /** Of the tasks that were accepted one by one, in their order. */
  List<Long> ids() {
    return ids;
  }

  /** Tasks of schedules that were taken, and of those that may have been. */
  boolean isScheduled(String task) {
    return schedules.containsKey(task);
  }

  /**
   * Judges what has become of it.
   *
   * @param kept all tasks of the run with their histories
   * @param taken the names of the tasks of all schedules
   */
  void judge(List<JsonNode> kept, List<String> taken) {
    List<String> names = new ArrayList<>();
    for (JsonNode task : kept) {
      names.add(task.get("name").asString());
      judgeEnd(task);
    }
    assertEquals(names.size(), new HashSet<>(names).size(), () -> "some twice: " + names);
    Set<String> unexplained = new HashSet<>(names);
    tasks.forEach(
        (name, answer) -> judgePresence(name, answer, unexplained.remove(name) ? 1 : 0, 1));
    imports.forEach(
        (beginning, answer) -> {
          int before = unexplained.size();
          unexplained.removeIf(name -> name.startsWith(beginning));
          judgePresence(beginning, answer, before - unexplained.size(), linesOfImport);
        });
    schedules.forEach(
        (name, answer) -> {
          Answer known = taken.contains(name) ? Answer.ACCEPTED : Answer.REFUSED;
          assertFalse(answer != Answer.UNKNOWN && answer != known, () -> name + ": " + answer);
          judgePresence(name, known, unexplained.remove(name) ? 1 : 0, 1);
        });
    assertEquals(Set.of(), unexplained, "nobody has asked for them");
  }

  private static void judgePresence(String what, Answer answer, int there, int all) {
    boolean isRight =
        switch (answer) {
          case ACCEPTED -> there == all;
          case REFUSED -> there == 0;
          case UNKNOWN -> there == 0 || there == all;
        };
    assertTrue(
        isRight, () -> "%s was %s, and %d of %d are kept".formatted(what, answer, there, all));
  }

  private void judgeEnd(JsonNode task) {
    String state = task.get("state").asString();
    Answer cancel = cancels.getOrDefault(task.get("id").asLong(), Answer.REFUSED);
    switch (cancel) {
      case ACCEPTED -> assertEquals("CANCELLED", state, task::toPrettyString);
      case REFUSED -> assertEquals("DONE", state, task::toPrettyString);
      case UNKNOWN -> assertTrue(Set.of("DONE", "CANCELLED").contains(state), task::toPrettyString);
    }
    boolean isDone = state.equals("DONE");
    assertEquals(1, additions(task), task::toPrettyString);
    assertEquals(isDone ? 1 : 0, eventCount(task, "Delivered"), task::toPrettyString);
    assertEquals(isDone ? 1 : 0, eventCount(task, "Done"), task::toPrettyString);
    long pickedUp = eventCount(task, "Picked up");
    assertTrue(pickedUp == 1 || (!isDone && pickedUp == 0), task::toPrettyString);
  }

  private static long additions(JsonNode task) {
    return task.get("history")
        .valueStream()
        .filter(event -> event.get("kind").asString().equals("task.added"))
        .count();
  }

  /** How often the task's history has a line that begins so. */
  static long eventCount(JsonNode task, String beginning) {
    return task.get("history")
        .valueStream()
        .filter(event -> event.get("text").asString().startsWith(beginning))
        .count();
  }
}
