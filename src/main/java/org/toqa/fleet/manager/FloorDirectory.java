package org.toqa.fleet.manager;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorChoice;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.grid.FloorMap;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The floors that there are, in their order. Any thread may ask; one thread at a time changes it.
 */
final class FloorDirectory {
  private volatile List<FloorEntry> entries = List.of();

  List<FloorEntry> all() {
    return entries;
  }

  synchronized void add(FloorEntry added) {
    List<FloorEntry> next = new ArrayList<>(entries);
    next.add(added);
    entries = List.copyOf(next);
  }

  synchronized void remove(FloorEntry removed) {
    entries = entries.stream().filter(entry -> entry != removed).toList();
  }

  Optional<FloorEntry> find(String name) {
    return entries.stream().filter(entry -> entry.name().equals(name)).findFirst();
  }

  /** The floor that an order names; the first one where it names none. */
  Optional<FloorEntry> resolve(@Nullable String name) {
    return name == null ? entries.stream().findFirst() : find(name);
  }

  List<FloorMap> maps() {
    return entries.stream().map(FloorEntry::map).toList();
  }

  /** The other floors by the names of their stations. */
  Map<String, String> stationsBeside(String floor) {
    Map<String, String> names = new HashMap<>();
    for (FloorMap map : maps()) {
      if (!map.name().equals(floor)) {
        map.stations().forEach(station -> names.putIfAbsent(station.name(), map.name()));
      }
    }
    return names;
  }

  /** The floor that an order means. */
  Optional<FloorEntry> resolve(@Nullable String name, Where start, Where goal) {
    return FloorChoice.among(maps(), name, start, goal).flatMap(map -> find(map.name()));
  }

  Optional<FloorEntry> resolve(TaskOrder order) {
    return resolve(order.floor(), order.start(), order.goal());
  }

  /** What is said to an order that names another. */
  Sentence noSuchFloor(@Nullable String name) {
    return Phrase.NO_SUCH_FLOOR_BUT.with(
        String.valueOf(name), Sentence.names(entries.stream().map(FloorEntry::name).toList()));
  }

  /** What is said where there is none of that name. */
  static <T> Answer<T> unknown(String name) {
    return new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(name));
  }
}
