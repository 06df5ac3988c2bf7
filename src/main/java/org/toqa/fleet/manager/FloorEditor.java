package org.toqa.fleet.manager;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.FloorStore;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.dispatch.SharedParts;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorLimits;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Adds, changes and removes floors, one change after the other on a thread of its own.
 *
 * <p>A map comes in force in these steps:
 *
 * <ol>
 *   <li>The floor is asked nothing new, and what was asked is answered.
 *   <li>The draft is checked against what is on the floor then.
 *   <li>It is stored as the map in force. A crash from here on finds it so.
 *   <li>The floor's agents end, and others go on from the store, as after a crash: robots drive
 *       what was released to them, and are planned anew on the new map.
 * </ol>
 *
 * Where the store falls silent before the last step is done, the floor stands until the store
 * answers again.
 */
final class FloorEditor implements FloorEditing, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(FloorEditor.class);
  private static final Duration RETRY = Duration.ofSeconds(2);

  private final FloorStore store;
  private final ScheduleStore schedules;
  private final FloorDirectory floors;
  private final RobotFloors robots;
  private final SharedParts shared;
  private final List<FloorListener> listeners;
  private final Consumer<FloorMap> starter;
  private final BiFunction<FloorEntry, FloorMap, FloorFleet> restarter;
  private final ScheduledExecutorService changes;

  /**
   * @param listeners are asked and told of each floor that is removed
   * @param starter starts a new floor and adds it to the directory
   * @param restarter starts agents of a floor on another map
   */
  FloorEditor(
      FloorStore store,
      ScheduleStore schedules,
      FloorDirectory floors,
      RobotFloors robots,
      SharedParts shared,
      List<FloorListener> listeners,
      Consumer<FloorMap> starter,
      BiFunction<FloorEntry, FloorMap, FloorFleet> restarter) {
    this.store = store;
    this.schedules = schedules;
    this.floors = floors;
    this.robots = robots;
    this.shared = shared;
    this.listeners = listeners;
    this.starter = starter;
    this.restarter = restarter;
    // a thread of its own, since it waits for agents to start and to end
    this.changes =
        Executors.newSingleThreadScheduledExecutor(
            Thread.ofPlatform().daemon().name("floors").factory());
    var _ =
        changes.scheduleWithFixedDelay(
            this::startThoseThatAwaitStore,
            RETRY.toMillis(),
            RETRY.toMillis(),
            TimeUnit.MILLISECONDS);
  }

  /** Where the store does not answer nothing is begun, so that no floor waits for it. */
  private <T> CompletionStage<T> inTurn(Supplier<T> change) {
    return shared.storeHealth().isAvailable()
        ? CompletableFuture.supplyAsync(change, changes)
        : CompletableFuture.failedFuture(
            new StoreException("The database does not answer, so nothing was changed.", null));
  }

  private FloorStore.Change change(EventKind kind, String user, Sentence text, String floor) {
    Instant at = shared.clock().instant();
    return new FloorStore.Change(
        user, at, List.of(new EventRecord(at, kind, null, null, user, text).onFloor(floor)));
  }

  @Override
  public CompletionStage<Answer<FloorMap>> addFloor(
      String name, FloorDrawing drawing, String user) {
    if (!FloorLimits.isFloorName(name)) {
      return CompletableFuture.completedFuture(
          new Answer.Rejected<>("name", Phrase.FLOOR_NAME_BAD.with()));
    }
    return inTurn(
        () -> {
          Map<String, String> elsewhere = floors.stationsBeside(name);
          Optional<Sentence> taken =
              drawing.stations().stream()
                  .flatMap(station -> MapCheck.takenName(station, elsewhere).stream())
                  .findFirst();
          if (taken.isPresent()) {
            return new Answer.Conflict<>(taken.get(), null);
          }
          FloorMap map = new FloorMap(name, drawing, margins());
          if (!addToStore(map, user)) {
            return new Answer.Rejected<>("name", Phrase.FLOOR_NAME_TAKEN.with(name));
          }
          try {
            starter.accept(map);
          } catch (IllegalStateException e) { // it is there, and says so itself
            log.error("{}", e.getMessage(), e);
          }
          return new Answer.Accepted<>(map);
        });
  }

  /** False: its name is taken. */
  private boolean addToStore(FloorMap map, String user) {
    String name = map.name();
    try {
      return store.addFloor(
          map, change(EventKind.FLOOR_ADDED, user, Phrase.FLOOR_ADDED.with(user, name), name));
    } catch (StoreException e) {
      reconcileDirectory(name);
      throw e;
    }
  }

  private Margins margins() {
    return floors.all().stream()
        .findFirst()
        .map(floor -> floor.map().margins())
        .orElse(Margins.USUAL);
  }

  @Override
  public CompletionStage<Answer<String>> removeFloor(String floor, String user) {
    return inTurn(
        () ->
            floors
                .find(floor)
                .map(entry -> remove(entry, user))
                .orElseGet(() -> FloorDirectory.unknown(floor)));
  }

  private Answer<String> remove(FloorEntry entry, String user) {
    String name = entry.name();
    AtomicReference<@Nullable Sentence> objection = new AtomicReference<>();
    boolean isRemoved =
        entry.remove(
            () -> {
              objection.set(objectionToRemoval(entry).orElse(null));
              if (objection.get() != null) {
                return false;
              }
              removeFromStore(name, user);
              floors.remove(entry); // from now on nobody finds it
              return true;
            });
    if (isRemoved) {
      listeners.forEach(listener -> tellRemoved(listener, name));
    }
    Sentence why = objection.get();
    return isRemoved || why == null
        ? new Answer.Accepted<>(name)
        : new Answer.Conflict<>(why, null);
  }

  private void removeFromStore(String floor, String user) {
    try {
      store.removeFloor(
          floor,
          change(EventKind.FLOOR_REMOVED, user, Phrase.FLOOR_REMOVED.with(user, floor), floor));
    } catch (StoreException e) {
      var _ = changes.schedule(() -> reconcileDirectory(floor), 0, TimeUnit.MILLISECONDS);
      throw e;
    }
  }

  private static void tellRemoved(FloorListener listener, String floor) {
    try {
      listener.floorRemoved(floor);
    } catch (RuntimeException e) { // the others are told
      log.error("What is kept of the removed floor {} is not forgotten.", floor, e);
    }
  }

  private Optional<Sentence> objectionToRemoval(FloorEntry entry) {
    String name = entry.name();
    int robotsHere = robots.count(name);
    int tasks = shared.taskFloors().openCount(name);
    int loads = shared.taskFloors().leftLoadCount(name);
    int orders = schedules(name).size();
    if (floors.all().size() == 1) {
      return Optional.of(Phrase.LAST_FLOOR.with());
    }
    return Stream.of(
            objection(robotsHere, Phrase.FLOOR_HAS_ROBOTS, name),
            objection(tasks, Phrase.FLOOR_HAS_TASKS, name),
            objection(loads, Phrase.FLOOR_HAS_LOADS, name),
            objection(orders, Phrase.FLOOR_HAS_SCHEDULES, name))
        .flatMap(Optional::stream)
        .findFirst()
        .or(
            () ->
                listeners.stream()
                    .flatMap(listener -> listener.objectionToRemoval(name).stream())
                    .findFirst());
  }

  private static Optional<Sentence> objection(int count, Phrase text, String floor) {
    return count > 0 ? Optional.of(text.with(floor, count)) : Optional.empty();
  }

  private static List<LeftLoad> leftLoads(FloorEntry entry) {
    return entry.snapshots().latest().floors().stream()
        .map(FloorView::leftLoads)
        .flatMap(List::stream)
        .toList();
  }

  /** Those that order tasks on the floor. */
  private List<Schedule> schedules(String floor) {
    List<FloorMap> all = floors.maps();
    return schedules.schedules().stream()
        .filter(schedule -> schedule.floor(all).equals(floor))
        .toList();
  }

  @Override
  public Optional<FloorDraft> draft(String floor) {
    return floors.find(floor).flatMap(entry -> store.draft(floor));
  }

  @Override
  public CompletionStage<Answer<FloorDraft>> saveDraft(
      String floor, FloorDrawing drawing, long seen, String user) {
    return onFloor(
        floor,
        entry ->
            store
                .saveDraft(floor, drawing, seen, user, shared.clock().instant())
                .<Answer<FloorDraft>>map(Answer.Accepted::new)
                .orElseGet(Answer.Outdated::new));
  }

  @Override
  public CompletionStage<Answer<FloorDraft>> discardDraft(
      String floor, @Nullable Long seen, String user) {
    return onFloor(
        floor,
        entry ->
            store.discardDraft(floor, seen)
                ? new Answer.Accepted<>(store.draft(floor).orElseThrow())
                : new Answer.Outdated<>());
  }

  private <T> CompletionStage<Answer<T>> onFloor(
      String floor, Function<FloorEntry, Answer<T>> work) {
    return inTurn(
        () -> floors.find(floor).map(work).orElseGet(() -> FloorDirectory.unknown(floor)));
  }

  @Override
  public CompletionStage<Answer<List<MapProblem>>> check(
      String floor, FloorDrawing drawing, String user) {
    return onFloor(floor, entry -> new Answer.Accepted<>(problems(entry, drawing)));
  }

  private List<MapProblem> problems(FloorEntry entry, FloorDrawing drawing) {
    List<TransportTask> tasks =
        shared.store().openTasks().stream()
            .map(open -> open.mission().task())
            .filter(task -> task.floor().equals(entry.name()))
            .toList();
    MapCheck check =
        new MapCheck(
            entry.map().grid(),
            floors.stationsBeside(entry.name()),
            entry.snapshots().latest().robots(),
            tasks,
            leftLoads(entry),
            schedules(entry.name()));
    return Stream.concat(
            check.problems(drawing).stream(),
            listeners.stream()
                .flatMap(listener -> listener.mapProblems(entry.name(), drawing).stream()))
        .toList();
  }

  @Override
  public CompletionStage<Answer<FloorMap>> publish(String floor, long seen, String user) {
    return onFloor(floor, entry -> publish(entry, seen, user));
  }

  private Answer<FloorMap> publish(FloorEntry entry, long seen, String user) {
    Publication publication = new Publication(entry, seen, user);
    try {
      entry.change(publication::decide, map -> restarter.apply(entry, map));
    } catch (IllegalStateException e) { // the map is in force, and the floor says so itself
      log.error("{}", e.getMessage(), e);
    } catch (StoreException e) {
      reconcile(entry);
      throw e;
    }
    return publication.answer;
  }

  /** One draft on its way to be in force. */
  private final class Publication {
    private final FloorEntry entry;
    private final long seen;
    private final String user;
    private Answer<FloorMap> answer = new Answer.Outdated<>();

    Publication(FloorEntry entry, long seen, String user) {
      this.entry = entry;
      this.seen = seen;
      this.user = user;
    }

    Optional<FloorMap> decide() {
      String floor = entry.name();
      FloorDraft draft = store.draft(floor).orElseThrow();
      if (draft.revision() != seen) {
        return Optional.empty();
      }
      if (!draft.isDraft()) {
        answer = new Answer.Conflict<>(Phrase.NO_DRAFT.with(floor), null);
        return Optional.empty();
      }
      List<Sentence> blocking =
          problems(entry, draft.drawing()).stream()
              .filter(MapProblem::isBlocking)
              .map(MapProblem::text)
              .toList();
      if (!blocking.isEmpty()) {
        answer =
            new Answer.Conflict<>(
                Phrase.MAP_HAS_PROBLEMS.with(Sentence.joined(Phrase.LISTED_APART, blocking)), null);
        return Optional.empty();
      }
      Optional<FloorMap> published =
          store.publish(
              floor,
              seen,
              change(
                  EventKind.FLOOR_MAP_PUBLISHED,
                  user,
                  Phrase.MAP_PUBLISHED.with(user, floor),
                  floor));
      published.ifPresent(map -> answer = new Answer.Accepted<>(map));
      return published;
    }
  }

  /** Nobody knows whether a map was stored: as soon as the store says so, it is in force or not. */
  private void reconcile(FloorEntry entry) {
    try {
      Optional<FloorMap> stored =
          store.floors().stream().filter(map -> map.name().equals(entry.name())).findFirst();
      entry.change(
          () -> stored.filter(map -> !map.drawing().equals(entry.map().drawing())),
          map -> restarter.apply(entry, map));
    } catch (StoreException e) {
      var _ = changes.schedule(() -> reconcile(entry), RETRY.toMillis(), TimeUnit.MILLISECONDS);
    } catch (IllegalStateException e) {
      log.error("{}", e.getMessage(), e);
    }
  }

  /** Likewise whether a floor was added or removed. */
  private void reconcileDirectory(String floor) {
    try {
      Optional<FloorMap> stored =
          store.floors().stream().filter(map -> map.name().equals(floor)).findFirst();
      Optional<FloorEntry> entry = floors.find(floor);
      if (stored.isPresent() && entry.isEmpty()) {
        starter.accept(new FloorMap(floor, stored.get().drawing(), margins()));
      } else if (stored.isEmpty() && entry.isPresent()) {
        forget(entry.get());
      }
    } catch (StoreException e) {
      var _ =
          changes.schedule(
              () -> reconcileDirectory(floor), RETRY.toMillis(), TimeUnit.MILLISECONDS);
    } catch (IllegalStateException e) {
      log.error("{}", e.getMessage(), e);
    }
  }

  private void forget(FloorEntry removed) {
    removed.remove(
        () -> {
          floors.remove(removed);
          return true;
        });
    listeners.forEach(listener -> tellRemoved(listener, removed.name()));
  }

  private void startThoseThatAwaitStore() {
    for (FloorEntry entry : floors.all()) {
      if (entry.awaitsStore() && shared.storeHealth().isAvailable()) {
        try {
          entry.startAgain(map -> restarter.apply(entry, map));
          log.info("The floor {} has started.", entry.name());
        } catch (RuntimeException e) { // else it would be the last try
          log.warn("{}", e.getMessage());
        }
      }
    }
  }

  @Override
  public Optional<FloorMap> mapAt(String floor, Instant at) {
    return store.mapAt(floor, at);
  }

  /** What was begun is done; nothing more is. */
  @Override
  public void close() {
    changes.shutdown();
    try {
      if (!changes.awaitTermination(RETRY.multipliedBy(5).toSeconds(), TimeUnit.SECONDS)) {
        log.warn("A change of a floor did not end in time.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
