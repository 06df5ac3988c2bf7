package org.toqa.web;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.grid.Place;
import org.toqa.testbed.Hall;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Floors and their drafts in memory, by the contract's rules; robots do not notice them. */
final class FloorsInMemory implements FloorEditing {
  private final SnapshotFeed snapshots;
  private final List<FloorMap> floors = new ArrayList<>();
  private final Map<String, FloorDraft> drafts = new TreeMap<>();
  private final Map<String, Instant> publishedAt = new TreeMap<>();
  private final Map<String, Long> revisions = new TreeMap<>();

  FloorsInMemory(SnapshotFeed snapshots) {
    this.snapshots = snapshots;
    forget();
  }

  synchronized void forget() {
    floors.clear();
    drafts.clear();
    publishedAt.clear();
    revisions.clear();
    floors.add(Hall.floor());
  }

  synchronized List<FloorMap> floors() {
    return List.copyOf(floors);
  }

  private Optional<FloorMap> floor(String name) {
    return floors.stream().filter(f -> f.name().equals(name)).findFirst();
  }

  @Override
  public synchronized CompletionStage<Answer<FloorMap>> addFloor(
      String name, FloorDrawing drawing, String user) {
    if (floor(name).isPresent()) {
      return done(
          new Answer.Rejected<>(
              "name", Sentence.verbatim("There is already a floor of that name. Choose another.")));
    }
    FloorMap added = new FloorMap(name, drawing, Margins.USUAL);
    floors.add(added);
    publishedAt.put(name, Instant.now());
    return done(new Answer.Accepted<>(added));
  }

  @Override
  public synchronized CompletionStage<Answer<String>> removeFloor(String name, String user) {
    return onFloor(
        name,
        () -> {
          if (snapshots.latest().robots().stream().anyMatch(r -> r.floor().equals(name))) {
            return new Answer.Conflict<>(
                Sentence.verbatim("Robots belong to this floor. Remove them first."), null);
          }
          floors.removeIf(f -> f.name().equals(name));
          drafts.remove(name);
          return new Answer.Accepted<>(name);
        });
  }

  @Override
  public synchronized Optional<FloorDraft> draft(String name) {
    return floor(name)
        .map(
            floor ->
                drafts.getOrDefault(
                    name, new FloorDraft(name, revision(name), floor.drawing(), null, null)));
  }

  private long revision(String name) {
    return revisions.getOrDefault(name, 0L);
  }

  private long nextRevision(String name) {
    return revisions.merge(name, 1L, Long::sum);
  }

  @Override
  public synchronized CompletionStage<Answer<FloorDraft>> saveDraft(
      String name, FloorDrawing drawing, long seen, String user) {
    return onFloor(
        name,
        () -> {
          if (draft(name).orElseThrow().revision() != seen) {
            return new Answer.Outdated<>();
          }
          FloorDraft saved = new FloorDraft(name, nextRevision(name), drawing, user, Instant.now());
          drafts.put(name, saved);
          return new Answer.Accepted<>(saved);
        });
  }

  @Override
  public synchronized CompletionStage<Answer<FloorDraft>> discardDraft(
      String name, @Nullable Long seen, String user) {
    return onFloor(
        name,
        () -> {
          if (seen != null && draft(name).orElseThrow().revision() != seen) {
            return new Answer.Outdated<>();
          }
          drafts.remove(name);
          nextRevision(name);
          return new Answer.Accepted<>(draft(name).orElseThrow());
        });
  }

  @Override
  public synchronized CompletionStage<Answer<List<MapProblem>>> check(
      String name, FloorDrawing drawing, String user) {
    return onFloor(name, () -> new Answer.Accepted<>(problems(name, drawing)));
  }

  private List<MapProblem> problems(String name, FloorDrawing drawing) {
    List<MapProblem> problems = new ArrayList<>();
    for (Place place : drawing.places().toList()) {
      if (!drawing.drivable().isFree(place.position())) {
        problems.add(problem(place.name() + " lies in a wall. Move it to a free cell.", place));
      }
    }
    for (RobotView robot : snapshots.latest().robots()) {
      var pose = robot.telemetry().pose();
      if (robot.floor().equals(name)
          && pose != null
          && !drawing.drivable().isFree(pose.position())) {
        Sentence text = Sentence.verbatim(robot.name() + " would stand in a wall. Move it first.");
        problems.add(new MapProblem(true, text, pose.position()));
      }
    }
    return problems;
  }

  private static MapProblem problem(String text, Place place) {
    return new MapProblem(true, Sentence.verbatim(text), place.position());
  }

  @Override
  public synchronized CompletionStage<Answer<FloorMap>> publish(
      String name, long seen, String user) {
    return onFloor(
        name,
        () -> {
          FloorDraft draft = draft(name).orElseThrow();
          if (draft.revision() != seen) {
            return new Answer.Outdated<>();
          }
          if (problems(name, draft.drawing()).stream().anyMatch(MapProblem::isBlocking)) {
            return new Answer.Conflict<>(
                Sentence.verbatim("The draft has problems. Solve them first."), null);
          }
          FloorMap published = new FloorMap(name, draft.drawing(), Margins.USUAL);
          floors.replaceAll(f -> f.name().equals(name) ? published : f);
          drafts.remove(name);
          nextRevision(name);
          publishedAt.put(name, Instant.now());
          return new Answer.Accepted<>(published);
        });
  }

  /** The last one is all that is remembered. */
  @Override
  public synchronized Optional<FloorMap> mapAt(String name, Instant at) {
    return floor(name).filter(f -> !at.isBefore(publishedAt.getOrDefault(name, Instant.EPOCH)));
  }

  private <T> CompletionStage<Answer<T>> onFloor(String name, Supplier<Answer<T>> command) {
    return done(
        floor(name).isPresent()
            ? command.get()
            : new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(name)));
  }

  private static <T> CompletionStage<Answer<T>> done(Answer<T> answer) {
    return CompletableFuture.completedFuture(answer);
  }
}
