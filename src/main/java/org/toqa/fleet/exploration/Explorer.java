package org.toqa.fleet.exploration;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.DoubleSupplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.exploration.ExplorationDrive;
import org.toqa.exploration.ExplorationOrder;
import org.toqa.exploration.HiddenGround;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorListener;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets swarms explore the floors of a site.
 *
 * <ol>
 *   <li>{@link #start} checks an order, and begins at once: one exploration at a time in all sites
 *       of the server.
 *   <li>It drives on a thread of its own, faster than it would in truth, and rests for at least
 *       three times as long as it computes. Whoever watches asks {@link #latest}; nobody need to.
 *   <li>It ends by itself, by {@link #stop}, or with the server. What was seen becomes the floor's
 *       draft, unless somebody has drawn there meanwhile; then {@link #draw} makes it so.
 *   <li>One that goes on is stored now and then. What was cut off by the death of the server ends
 *       as such at its next start ({@link #recover}), with what was stored of it.
 * </ol>
 *
 * <p>Of each floor the last one is kept; beginning and end are in the history. Any thread may call
 * it.
 */
public final class Explorer implements FloorListener, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Explorer.class);

  /** Before the name of a floor whose map in force is the ground. */
  public static final String FLOOR = "floor:";

  /** Before the name of a ground that is shipped. */
  public static final String SCENE = "scene:";

  /** Simulated seconds a second, for people who watch. */
  public static final double WATCHED = 4;

  /** Of the processor that it drives on, at most so much is taken. */
  private static final double SHARE = 0.25;

  private static final Duration LIMIT = Duration.ofSeconds(10);

  /** Between two pictures that are stored, and before what could not be stored is tried again. */
  private static final Duration STORE_PERIOD = Duration.ofSeconds(5);

  /** Steps between two pictures. */
  private static final int PICTURE_STEPS = 3;

  private final ExplorationStore store;
  private final Fleet fleet;

  /** One at a time. */
  private final Semaphore slot = new Semaphore(1);

  private final InstantSource clock;
  private final DoubleSupplier speed;
  private final Map<String, Exploration> latest = new ConcurrentHashMap<>();
  private final Map<String, Running> running = new ConcurrentHashMap<>();
  private final ScheduledThreadPoolExecutor thread =
      new ScheduledThreadPoolExecutor(
          1,
          Thread.ofPlatform().daemon().name("exploration").priority(Thread.MIN_PRIORITY).factory());
  private volatile boolean isClosed;

  /** One that goes on; driven by the thread alone. */
  private static final class Running {
    final ExplorationDrive drive;
    final Exploration begun;
    final FloorDraft draft;
    final CompletableFuture<Exploration> end = new CompletableFuture<>();
    volatile @Nullable String stopper;
    int steps;
    long dueNanos = System.nanoTime();
    long storedNanos = System.nanoTime();

    Running(ExplorationDrive drive, Exploration begun, FloorDraft draft) {
      this.drive = drive;
      this.begun = begun;
      this.draft = draft;
    }
  }

  /**
   * @param speed simulated seconds a second, asked at each step; infinite: as fast as it can
   */
  public Explorer(ExplorationStore store, Fleet fleet, InstantSource clock, DoubleSupplier speed) {
    this.store = store;
    this.fleet = fleet;
    this.clock = clock;
    this.speed = speed;
    thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    thread.prestartCoreThread(); // not by a request, of whose application it would be
  }

  /** Knows what is stored, and ends what the server left behind. To be called once, at first. */
  public void recover() {
    for (Exploration stored : store.explorations()) {
      latest.put(stored.floor(), stored);
      if (!stored.state().isOver()) {
        thread.execute(() -> endInterrupted(stored));
      }
    }
  }

  private void endInterrupted(Exploration stored) {
    Exploration last = stored.with(Exploration.State.INTERRUPTED, stored.picture());
    Optional<FloorDraft> draft = fleet.floorEditing().draft(stored.floor());
    if (draft.isEmpty()) {
      var _ = ended(last, Exploration.Draft.NOT_SAVED, null);
      return;
    }
    var _ =
        keepSeen(last, draft.get().drawing())
            .thenAcceptAsync(became -> ended(last, became, null), thread);
  }

  /** The last exploration of a floor. */
  public Optional<Exploration> latest(String floor) {
    return Optional.ofNullable(latest.get(floor));
  }

  /**
   * The ground of that name: {@code scene:} and a {@link HiddenGround}, or {@code floor:} and a
   * floor, whose map in force it is; empty: there is none.
   */
  public Optional<OccupancyGrid> ground(String name) {
    if (name.startsWith(SCENE)) {
      return HiddenGround.named(name.substring(SCENE.length())).map(HiddenGround::grid);
    }
    return fleet.floors().stream()
        .filter(floor -> name.equals(FLOOR + floor.name()))
        .map(floor -> floor.drawing().walls())
        .findFirst();
  }

  /** Begins one. */
  public Answer<Exploration> start(
      String floor, String ground, ExplorationOrder order, String user) {
    Optional<FloorDraft> draft = fleet.floorEditing().draft(floor);
    Optional<OccupancyGrid> truth = ground(ground);
    if (draft.isEmpty()) {
      return new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor));
    }
    if (truth.isEmpty()) {
      return new Answer.Rejected<>("ground", Phrase.EXPLORATION_NO_GROUND.with());
    }
    Optional<Answer<Exploration>> refusal = refusal(truth.get(), order);
    if (refusal.isPresent()) {
      return refusal.get();
    }
    String drawer = draft.get().user();
    if (drawer != null) {
      return new Answer.Conflict<>(Phrase.EXPLORATION_DRAFT_EXISTS.with(floor, drawer), null);
    }
    if (latest(floor).filter(last -> !last.state().isOver()).isPresent() || !slot.tryAcquire()) {
      return new Answer.Conflict<>(Phrase.EXPLORATION_RUNS.with(), null);
    }
    boolean isBegun = false;
    try {
      Optional<Exploration> begun = begin(floor, ground, truth.get(), order, user, draft.get());
      isBegun = begun.isPresent();
      return begun
          .<Answer<Exploration>>map(Answer.Accepted::new)
          .orElseGet(() -> new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor)));
    } finally {
      if (!isBegun) {
        slot.release();
      }
    }
  }

  /** Empty: the floor is there no more. */
  private synchronized Optional<Exploration> begin(
      String floor,
      String ground,
      OccupancyGrid truth,
      ExplorationOrder order,
      String user,
      FloorDraft draft) {
    if (fleet.floorEditing().draft(floor).isEmpty()) {
      return Optional.empty();
    }
    ExplorationDrive drive = new ExplorationDrive(truth, order);
    Exploration begun =
        new Exploration(
            floor,
            ground,
            order,
            user,
            draft.revision(),
            clock.instant(),
            null,
            Exploration.State.RUNNING,
            drive.picture(),
            Exploration.Draft.NONE_YET);
    Running now = new Running(drive, begun, draft);
    Sentence sentence =
        Phrase.EXPLORATION_BEGAN.with(user, order.robots(), floor, String.valueOf(order.seed()));
    store.save(begun, List.of(event(begun, EventKind.EXPLORATION_BEGAN, user, sentence)));
    latest.put(floor, begun);
    running.put(floor, now);
    thread.execute(() -> advance(now));
    return Optional.of(begun);
  }

  @Override
  public Optional<Sentence> objectionToRemoval(String floor) {
    return latest(floor)
        .filter(last -> !last.state().isOver())
        .map(_ -> Phrase.FLOOR_IS_EXPLORED.with(floor));
  }

  @Override
  public synchronized void floorRemoved(String floor) {
    latest.remove(floor);
    store.remove(floor);
  }

  /**
   * Shows and stores what an exploration has come to, unless its floor was removed: one that has
   * its name now is another one.
   */
  private synchronized void keep(Exploration next, List<EventRecord> events) {
    if (isKept(next)) {
      latest.put(next.floor(), next);
      store.save(next, events);
    }
  }

  private boolean isKept(Exploration exploration) {
    return latest(exploration.floor()).filter(now -> isSame(now, exploration)).isPresent();
  }

  private static boolean isSame(Exploration now, Exploration before) {
    return now.startedAt().equals(before.startedAt());
  }

  private static Optional<Answer<Exploration>> refusal(
      OccupancyGrid truth, ExplorationOrder order) {
    if (!ExplorationDrive.isSimulated(truth)) {
      return Optional.of(new Answer.Rejected<>("ground", Phrase.EXPLORATION_GROUND_LARGE.with()));
    }
    if (!ExplorationDrive.fits(truth, order)) {
      return Optional.of(
          new Answer.Rejected<>("start", Phrase.EXPLORATION_START_BLOCKED.with(order.robots())));
    }
    return truth.contains(truth.cellAt(order.target()))
        ? Optional.empty()
        : Optional.of(new Answer.Rejected<>("target", Phrase.EXPLORATION_TARGET_OUTSIDE.with()));
  }

  private void advance(Running now) {
    if (!isKept(now.begun)) { // its floor was removed when it had just begun
      running.remove(now.begun.floor(), now);
      slot.release();
      now.end.complete(now.begun.with(Exploration.State.STOPPED, now.begun.picture()));
      return;
    }
    Exploration last = now.begun.with(Exploration.State.FAILED, now.begun.picture());
    try {
      Exploration.State state =
          now.stopper != null || isClosed ? Exploration.State.STOPPED : driveOneStep(now);
      if (!state.isOver()) {
        return;
      }
      last = now.begun.with(state, now.drive.picture());
    } catch (RuntimeException | Error e) {
      log.error("The exploration of {} failed.", now.begun.floor(), e);
    }
    end(now, last);
  }

  /** Drives a step, and has the next one done when it is time. */
  private Exploration.State driveOneStep(Running now) {
    long begin = System.nanoTime();
    ExplorationDrive.State state = now.drive.step();
    if (state != ExplorationDrive.State.DRIVING) {
      return Exploration.State.valueOf(state.name());
    }
    now.steps++;
    if (now.steps % PICTURE_STEPS == 0) {
      show(now);
    }
    double pace = speed.getAsDouble();
    if (Double.isFinite(pace)) {
      long end = System.nanoTime();
      long rest = (long) ((end - begin) * (1 / SHARE - 1));
      long due = now.dueNanos + (long) (1e9 * ExplorationDrive.STEP / pace);
      now.dueNanos = Math.max(due, end + rest);
      var _ = thread.schedule(() -> advance(now), now.dueNanos - end, TimeUnit.NANOSECONDS);
    } else {
      thread.execute(() -> advance(now));
    }
    return Exploration.State.RUNNING;
  }

  private void show(Running now) {
    Exploration seen = now.begun.with(Exploration.State.RUNNING, now.drive.picture());
    if (System.nanoTime() - now.storedNanos < STORE_PERIOD.toNanos()) {
      var _ =
          latest.computeIfPresent(
              seen.floor(), (_, before) -> isSame(before, seen) ? seen : before);
      return;
    }
    try {
      keep(seen, List.of());
    } catch (StoreException e) {
      log.debug("An exploration that goes on is not stored: {}", e.toString());
    }
    now.storedNanos = System.nanoTime();
  }

  private void end(Running now, Exploration last) {
    var _ =
        keepSeen(last, now.draft.drawing())
            .thenAcceptAsync(
                became -> {
                  Exploration ended = ended(last, became, now.stopper);
                  running.remove(last.floor());
                  slot.release();
                  now.end.complete(ended);
                },
                thread);
  }

  /** What was seen becomes the draft, if there is none but that of the beginning. */
  private CompletableFuture<Exploration.Draft> keepSeen(Exploration last, FloorDrawing drawing) {
    CompletionStage<Answer<FloorDraft>> saved;
    try {
      saved = save(last, last.revision(), drawing, last.user());
    } catch (RuntimeException | Error e) {
      saved = CompletableFuture.failedStage(e);
    }
    return saved
        .thenApply(
            answer ->
                answer instanceof Answer.Accepted<FloorDraft>
                    ? Exploration.Draft.SAVED
                    : Exploration.Draft.NOT_SAVED)
        .toCompletableFuture()
        .orTimeout(LIMIT.toMillis(), TimeUnit.MILLISECONDS)
        .exceptionally(
            e -> {
              log.warn("What was seen of {} is not stored: {}", last.floor(), e.toString());
              return Exploration.Draft.NOT_SAVED;
            });
  }

  private Exploration ended(Exploration last, Exploration.Draft became, @Nullable String stopper) {
    Exploration ended = last.ended(clock.instant(), became);
    try {
      keepInTheEnd(ended, List.of(end(ended, stopper)));
    } catch (RuntimeException e) {
      log.error("The end of the exploration of {} cannot be stored.", ended.floor(), e);
    }
    return ended;
  }

  /** Tries again while the store does not answer. */
  private void keepInTheEnd(Exploration exploration, List<EventRecord> events) {
    try {
      keep(exploration, events);
    } catch (StoreException e) {
      log.warn(
          "The exploration of {} is not stored, which is tried again: {}",
          exploration.floor(),
          e.toString());
      var _ =
          thread.schedule(
              () -> {
                Exploration now = latest.get(exploration.floor());
                if (now != null && isSame(now, exploration)) {
                  keepInTheEnd(now, events);
                }
              },
              STORE_PERIOD.toNanos(),
              TimeUnit.NANOSECONDS);
    }
  }

  /** What the history says of an end. */
  private static EventRecord end(Exploration ended, @Nullable String stopper) {
    String floor = ended.floor();
    return switch (ended.state()) {
      case REACHED -> event(ended, EventKind.EXPLORATION_ENDED, Phrase.EXPLORATION_REACHED);
      case NO_WAY -> event(ended, EventKind.EXPLORATION_ENDED, Phrase.EXPLORATION_NO_WAY);
      case LOST -> event(ended, EventKind.EXPLORATION_ENDED, Phrase.EXPLORATION_LOST);
      case OUT_OF_TIME -> event(ended, EventKind.EXPLORATION_ENDED, Phrase.EXPLORATION_OUT_OF_TIME);
      case STOPPED ->
          stopper == null
              ? event(ended, EventKind.EXPLORATION_STOPPED, Phrase.EXPLORATION_SHUT_DOWN)
              : event(
                  ended,
                  EventKind.EXPLORATION_STOPPED,
                  stopper,
                  Phrase.EXPLORATION_STOPPED.with(stopper, floor));
      case INTERRUPTED -> event(ended, EventKind.EXPLORATION_FAILED, Phrase.EXPLORATION_CUT_OFF);
      case FAILED -> event(ended, EventKind.EXPLORATION_FAILED, Phrase.EXPLORATION_BROKE);
      case RUNNING -> throw new IllegalArgumentException("It goes on: " + floor);
    };
  }

  private static EventRecord event(Exploration ended, EventKind kind, Phrase phrase) {
    return event(ended, kind, EventRecord.SYSTEM, phrase.with(ended.floor()));
  }

  private static EventRecord event(
      Exploration exploration, EventKind kind, String who, Sentence sentence) {
    Instant at = exploration.endedAt() == null ? exploration.startedAt() : exploration.endedAt();
    return new EventRecord(at, kind, null, null, who, sentence).onFloor(exploration.floor());
  }

  /**
   * Ends the one of a floor: completed when what was seen is the draft, or cannot be.
   *
   * @param user who wants it
   * @return a conflict where none goes on
   */
  public CompletionStage<Answer<Exploration>> stop(String floor, String user) {
    Running now = running.get(floor);
    if (now == null) {
      return CompletableFuture.completedStage(
          new Answer.Conflict<>(Phrase.EXPLORATION_RUNS_NOT.with(floor), null));
    }
    now.stopper = user;
    return now.end.thenApply(Answer.Accepted::new);
  }

  /** What was seen becomes the floor's draft now, in place of the one that somebody has drawn. */
  public CompletionStage<Answer<Exploration>> draw(String floor, String user) {
    Exploration last = latest.get(floor);
    Optional<FloorDraft> draft = fleet.floorEditing().draft(floor);
    if (last == null || draft.isEmpty() || !last.state().isOver()) {
      return CompletableFuture.completedStage(
          new Answer.Conflict<>(Phrase.EXPLORATION_NOTHING_TO_DRAW.with(floor), null));
    }
    return save(last, draft.get().revision(), draft.get().drawing(), user)
        .thenApply(
            answer -> {
              if (!(answer instanceof Answer.Accepted<FloorDraft>)) {
                return answer.asRejection();
              }
              Exploration saved = last.saved();
              if (latest.replace(floor, last, saved)) {
                thread.execute(() -> keepInTheEnd(saved, List.of()));
              }
              return new Answer.Accepted<>(saved);
            });
  }

  /**
   * Makes what was seen the draft; places and areas stay as they are drawn.
   *
   * @param seen the revision that the draft has to have yet
   */
  private CompletionStage<Answer<FloorDraft>> save(
      Exploration exploration, long seen, FloorDrawing drawing, String user) {
    List<Vec2> places = drawing.places().map(Place::position).toList();
    FloorDrawing drawn = drawing.withWalls(exploration.picture().seen().map(places));
    return fleet.floorEditing().saveDraft(exploration.floor(), drawn, seen, user);
  }

  /** What goes on is stopped, and what it saw is kept as the draft. */
  @Override
  public void close() {
    isClosed = true;
    for (Running now : running.values()) {
      try {
        now.end.get(LIMIT.toMillis(), TimeUnit.MILLISECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } catch (ExecutionException | TimeoutException e) {
        log.warn("An exploration does not end.", e);
      }
    }
    thread.shutdown();
  }
}
