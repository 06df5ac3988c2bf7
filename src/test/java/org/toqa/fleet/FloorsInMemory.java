package org.toqa.fleet;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;

/** Floors that nothing outlives. */
public final class FloorsInMemory implements FloorStore {
  private final List<FloorMap> floors = new ArrayList<>();
  private final Map<String, FloorDraft> drafts = new HashMap<>();
  private Runnable whileRemoving = () -> {};
  private Runnable afterChange = () -> {};

  private FloorsInMemory(List<FloorMap> floors) {
    this.floors.addAll(floors);
  }

  public static FloorsInMemory of(FloorMap... floors) {
    return new FloorsInMemory(List.of(floors));
  }

  @Override
  public synchronized List<FloorMap> floors() {
    return List.copyOf(floors);
  }

  @Override
  public synchronized boolean addFloor(FloorMap map, Change change) {
    boolean isNew =
        floors.stream().noneMatch(f -> f.name().equalsIgnoreCase(map.name())) && floors.add(map);
    afterChange.run();
    return isNew;
  }

  /** What happens after a floor was added or removed, and before that is known. */
  synchronized void setAfterChange(Runnable then) {
    afterChange = then;
  }

  /** What happens after it is decided that a floor is removed, and before it is. */
  synchronized void setWhileRemoving(Runnable meanwhile) {
    whileRemoving = meanwhile;
  }

  @Override
  public synchronized void removeFloor(String floor, Change change) {
    whileRemoving.run();
    floors.removeIf(f -> f.name().equals(floor));
    afterChange.run();
  }

  private Optional<FloorMap> find(String floor) {
    return floors.stream().filter(f -> f.name().equals(floor)).findFirst();
  }

  @Override
  public synchronized Optional<FloorDraft> draft(String floor) {
    return find(floor)
        .map(
            map ->
                drafts.computeIfAbsent(
                    floor, _ -> new FloorDraft(floor, 1, map.drawing(), null, null)));
  }

  @Override
  public synchronized Optional<FloorDraft> saveDraft(
      String floor, FloorDrawing drawing, long seen, String user, Instant at) {
    return draft(floor)
        .filter(draft -> draft.revision() == seen)
        .map(
            draft -> {
              FloorDraft next = new FloorDraft(floor, seen + 1, drawing, user, at);
              drafts.put(floor, next);
              return next;
            });
  }

  @Override
  public synchronized boolean discardDraft(String floor, @Nullable Long seen) {
    if (seen != null && draft(floor).filter(draft -> draft.revision() == seen).isEmpty()) {
      return false;
    }
    draft(floor)
        .filter(FloorDraft::isDraft)
        .ifPresent(
            draft ->
                drafts.put(
                    floor,
                    new FloorDraft(
                        floor,
                        draft.revision() + 1,
                        find(floor).orElseThrow().drawing(),
                        null,
                        null)));
    return true;
  }

  @Override
  public synchronized Optional<FloorMap> publish(String floor, long seen, Change change) {
    return draft(floor)
        .filter(draft -> draft.revision() == seen && draft.isDraft())
        .map(
            draft -> {
              FloorMap before = find(floor).orElseThrow();
              FloorMap map = new FloorMap(floor, draft.drawing(), before.margins());
              floors.set(floors.indexOf(before), map);
              drafts.put(floor, new FloorDraft(floor, seen + 1, map.drawing(), null, null));
              return map;
            });
  }

  @Override
  public synchronized Optional<FloorMap> mapAt(String floor, Instant at) {
    return find(floor);
  }
}
