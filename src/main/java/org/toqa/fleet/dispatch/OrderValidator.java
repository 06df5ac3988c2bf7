package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotOrder;
import org.toqa.fleet.RobotOrder.HttpAccess;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.Mission;
import org.toqa.mission.RobotAbility;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Checks orders against the floors before anything of them is stored. Any thread may ask. */
final class OrderValidator {
  private final FloorMap floor;
  private final Set<String> gateways;
  private final PathQuery paths;

  /**
   * @param gateways the names of those that there are
   */
  OrderValidator(FloorMap floor, Set<String> gateways, PathQuery paths) {
    this.floor = floor;
    this.gateways = Set.copyOf(gateways);
    this.paths = paths;
  }

  /**
   * Checks an order for a task. Paths are planned on another thread, so the answer may come later.
   *
   * @param capacity of all robots that there are
   * @param check of this order
   * @return the task, its id not known yet; or the sentence against it, with the order's field
   */
  CompletionStage<Answer<TransportTask>> checkTask(
      TaskOrder order, String user, Instant now, Capacity capacity, OrderChecks.Check check) {
    return checkAll(order, user, now, capacity, check).thenApply(List::getFirst);
  }

  /**
   * The same, with all the sentences against it.
   *
   * @return the task alone, or one rejection or more
   */
  CompletionStage<List<Answer<TransportTask>>> checkAll(
      TaskOrder order, String user, Instant now, Capacity capacity, OrderChecks.Check check) {
    List<Answer<TransportTask>> resolved = resolveTask(order, user, now, capacity);
    return resolved.getFirst() instanceof Answer.Accepted<TransportTask>(TransportTask task)
        ? (task.legs().isEmpty()
                ? CompletableFuture.<Answer<TransportTask>>completedFuture(
                    new Answer.Accepted<>(task))
                : checkPaths(task, task.legs(), capacity, check))
            .thenCompose(checked -> checkRoom(checked, capacity, check))
            .thenApply(List::of)
        : CompletableFuture.completedFuture(resolved);
  }

  /** All of the check that needs no path. */
  private List<Answer<TransportTask>> resolveTask(
      TaskOrder order, String user, Instant now, Capacity capacity) {
    List<Answer<TransportTask>> rejections = new ArrayList<>();
    if (order.load() > capacity.total()) {
      rejections.add(
          new Answer.Rejected<>(
              "load", Phrase.TOO_HEAVY_TOGETHER.with(order.load(), capacity.total())));
    } else {
      objectionToChosen(order, capacity)
          .ifPresent(why -> rejections.add(new Answer.Rejected<>("onlyRobots", why)));
    }
    List<Answer<TaskPlace>> resolved = resolvePlaces(order);
    resolved.stream()
        .filter(place -> !(place instanceof Answer.Accepted<TaskPlace>))
        .forEach(place -> rejections.add(place.asRejection()));
    List<TaskPlace> places =
        resolved.stream()
            .flatMap(
                place ->
                    place instanceof Answer.Accepted<TaskPlace>(TaskPlace known)
                        ? Stream.of(known)
                        : Stream.empty())
            .toList();
    if (places.size() == resolved.size()) {
      samePlace(places).ifPresent(i -> rejections.add(samePlace(order, i)));
      if (rejections.isEmpty()) {
        TransportTask task = order.task(places, floor.name(), user, now);
        rejections.addAll(capacity.arms().objections(task));
        if (rejections.isEmpty()) {
          return List.of(new Answer.Accepted<>(task));
        }
      }
    }
    return rejections;
  }

  /** The places of its way in order, or what speaks against them. */
  private List<Answer<TaskPlace>> resolvePlaces(TaskOrder order) {
    if (order.stops().isEmpty()) {
      return List.of(
          resolvePlace(Phrase.START, "start", order.start()),
          resolvePlace(Phrase.GOAL, "goal", order.goal()));
    }
    List<Answer<TaskPlace>> places = new ArrayList<>();
    Vec2 before = Vec2.ZERO;
    for (int i = 0; i < order.stops().size(); i++) {
      Where where = order.stops().get(i).where();
      Answer<TaskPlace> place =
          where instanceof Where.Charger(String name)
              ? resolveCharger(stopField(i), name, before)
              : resolvePlace(Phrase.PLACE, stopField(i), where);
      if (place instanceof Answer.Accepted<TaskPlace>(TaskPlace known)) {
        before = known.position();
      }
      places.add(place);
    }
    return places;
  }

  /**
   * The charging point of that name.
   *
   * @param name null: the nearest one stands for the one that the robot will choose
   * @param from where the robot comes from
   */
  private Answer<TaskPlace> resolveCharger(String field, @Nullable String name, Vec2 from) {
    if (floor.charging().isEmpty()) {
      return new Answer.Rejected<>(field, Phrase.NO_CHARGERS.with());
    }
    return floor.charging().stream()
        .filter(point -> name == null || point.name().equals(name))
        .min(Comparator.comparingDouble(point -> point.position().distanceTo(from)))
        .map(point -> checkStandable(Phrase.PLACE, field, new TaskPlace(point.position(), null)))
        .orElseGet(
            () ->
                new Answer.Rejected<>(
                    field,
                    Phrase.NO_SUCH_CHARGER.with(
                        Objects.requireNonNull(name), names(floor.charging()))));
  }

  private static String stopField(int stop) {
    return "stops." + stop;
  }

  /** The number of the first one that is where the one before it is. */
  private OptionalInt samePlace(List<TaskPlace> places) {
    OccupancyGrid grid = floor.grid();
    return IntStream.range(1, places.size())
        .filter(
            i ->
                grid.cellAt(places.get(i - 1).position())
                    .equals(grid.cellAt(places.get(i).position())))
        .findFirst();
  }

  private static Answer<TransportTask> samePlace(TaskOrder order, int stop) {
    return order.stops().isEmpty()
        ? new Answer.Rejected<>("goal", Phrase.SAME_PLACE.with())
        : new Answer.Rejected<>(stopField(stop), Phrase.SAME_AS_STOP_BEFORE.with());
  }

  /** Of the robots that alone may carry it: whether they are there, and can. */
  private Optional<Sentence> objectionToChosen(TaskOrder order, Capacity capacity) {
    List<String> chosen = capacity.chosen().names(order.onlyRobots());
    Optional<RobotAbility> lacking =
        chosen.stream().flatMap(word -> RobotAbility.of(word).stream()).findFirst();
    if (lacking.isPresent()) {
      return Optional.of(Phrase.NONE_IS_ABLE.with(lacking.get().robots()));
    }
    Optional<String> unknown =
        chosen.stream().filter(robot -> !capacity.maxLoads().containsKey(robot)).findFirst();
    if (unknown.isPresent()) {
      List<String> known = capacity.maxLoads().keySet().stream().sorted().toList();
      return Optional.of(
          Phrase.NO_SUCH_ROBOT_ON_FLOOR.with(
              unknown.get(),
              Sentence.verbatim(floor.name()),
              known.isEmpty() ? Phrase.NONE_ON_FLOOR.with() : Sentence.names(known)));
    }
    return capacity.isEnoughFor(order.load(), chosen)
        ? Optional.empty()
        : Optional.of(
            Phrase.TOO_HEAVY_FOR_CHOSEN.with(
                order.load(), ChosenRobots.words(order.onlyRobots()), capacity.together(chosen)));
  }

  /**
   * The path between two places, as the smallest robot drives it on a floor where it is alone.
   *
   * @param check what it is asked for
   * @return the path; or the sentence against it, with the question's field
   */
  CompletionStage<Answer<PathAnswer>> findPath(PathQuestion question, OrderChecks.Check check) {
    Answer<TaskPlace> start = resolvePlace(Phrase.START, "start", question.start());
    Answer<TaskPlace> goal = resolvePlace(Phrase.GOAL, "goal", question.goal());
    if (!(start instanceof Answer.Accepted<TaskPlace>(TaskPlace from))) {
      return CompletableFuture.completedFuture(start.asRejection());
    }
    if (!(goal instanceof Answer.Accepted<TaskPlace>(TaskPlace to))) {
      return CompletableFuture.completedFuture(goal.asRejection());
    }
    OccupancyGrid grid = floor.grid();
    if (grid.cellAt(from.position()).equals(grid.cellAt(to.position()))) {
      List<Vec2> straight = List.of(from.position(), to.position());
      return CompletableFuture.completedFuture(
          new Answer.Accepted<>(new PathAnswer(floor.name(), straight)));
    }
    return paths
        .findPath(grid, from.position(), to.position(), 2 * PlaceCheck.SMALLEST_RADIUS, check)
        .thenApply(
            path ->
                switch (path) {
                  case FloorPath.Found(List<Vec2> points) ->
                      new Answer.Accepted<>(new PathAnswer(floor.name(), points));
                  case FloorPath.FoundBetweenCells _ ->
                      new Answer.Accepted<>(new PathAnswer(floor.name(), List.of()));
                  case FloorPath.NotFound _ -> noPath(from, to);
                });
  }

  private static <T> Answer<T> noPath(TaskPlace from, TaskPlace to) {
    return new Answer.Rejected<>(
        "goal", Phrase.NO_WAY_BETWEEN.with(from.sentence(), to.sentence()));
  }

  /** Each leg after the one before it. */
  private CompletionStage<Answer<TransportTask>> checkPaths(
      TransportTask task, List<TransportTask> legs, Capacity capacity, OrderChecks.Check check) {
    CompletionStage<Answer<TransportTask>> first = checkPath(legs.getFirst(), capacity, check);
    return first.thenCompose(
        checked -> {
          if (!(checked instanceof Answer.Accepted<TransportTask>)) {
            return CompletableFuture.completedFuture(checked);
          }
          return legs.size() == 1
              ? CompletableFuture.completedFuture(new Answer.Accepted<>(task))
              : checkPaths(task, legs.subList(1, legs.size()), capacity, check);
        });
  }

  /** Whether there is a path, for the smallest robot, and for the load where one carries it. */
  private CompletionStage<Answer<TransportTask>> checkPath(
      TransportTask task, Capacity capacity, OrderChecks.Check check) {
    LoadSize size = task.size();
    return hasPath(task, 2 * PlaceCheck.SMALLEST_RADIUS, check)
        .thenCompose(
            hasPath ->
                !hasPath
                    ? CompletableFuture.completedFuture(noPath(task.start(), task.goal()))
                    : size == null || !capacity.narrowestTeams(task).isEmpty()
                        ? CompletableFuture.completedFuture(new Answer.Accepted<>(task))
                        : checkPathWithLoad(task, size, check));
  }

  private CompletionStage<Answer<TransportTask>> checkPathWithLoad(
      TransportTask task, LoadSize size, OrderChecks.Check check) {
    return hasPath(task, Math.max(size.diameter(), 2 * PlaceCheck.SMALLEST_RADIUS), check)
        .thenApply(
            hasPath ->
                hasPath
                    ? new Answer.Accepted<>(task)
                    : new Answer.Rejected<>(
                        "load",
                        Phrase.NO_WAY_FOR_LOAD.with(
                            task.start().sentence(),
                            task.goal().sentence(),
                            size.length(),
                            size.width(),
                            size.diameter())));
  }

  private CompletionStage<Boolean> hasPath(
      TransportTask task, double diameter, OrderChecks.Check check) {
    OccupancyGrid grid = floor.grid();
    return paths
        .findPath(grid, task.start().position(), task.goal().position(), diameter, check)
        .thenApply(path -> !(path instanceof FloorPath.NotFound));
  }

  /**
   * Whether as many robots as it takes, the narrowest that there are, have room on the map: what
   * they have none for now waits, what they never will is refused. Where that does not show in
   * time, it waits.
   */
  private CompletionStage<Answer<TransportTask>> checkRoom(
      Answer<TransportTask> checked, Capacity capacity, OrderChecks.Check check) {
    if (!(checked instanceof Answer.Accepted<TransportTask>(TransportTask task))) {
      return CompletableFuture.completedFuture(checked);
    }
    if (task.hasCharging() && !capacity.narrowestTeams(task).isEmpty()) {
      return CompletableFuture.completedFuture(
          new Answer.Rejected<>("load", Phrase.CHARGING_NEEDS_ONE_ROBOT.with(task.load())));
    }
    Mission mission = Mission.queued(task);
    return paths
        .objectionToTeams(floor, mission, capacity.narrowestTeams(task), check)
        .exceptionally(OrderValidator::noObjectionInTime)
        .thenApply(
            objection ->
                objection
                    .<Answer<TransportTask>>map(why -> new Answer.Rejected<>("load", why))
                    .orElse(checked));
  }

  private static Optional<Sentence> noObjectionInTime(Throwable failure) {
    Throwable cause = failure instanceof CompletionException e ? e.getCause() : failure;
    if (cause instanceof CheckRefusedException) {
      return Optional.empty();
    }
    throw new CompletionException(cause);
  }

  Answer<RobotRecord> checkRobot(RobotOrder order, List<RobotRecord> existing) {
    if (existing.stream().anyMatch(r -> r.name().equalsIgnoreCase(order.name()))) {
      return new Answer.Rejected<>("name", Phrase.ROBOT_NAME_TAKEN.with(order.name()));
    }
    Optional<Sentence> ofGateway = objectionToGateway(order.gateway());
    if (ofGateway.isPresent()) {
      return new Answer.Rejected<>("gateway", ofGateway.get());
    }
    HttpAccess http = order.http();
    if (http != null && order.gateway() != null) {
      return new Answer.Rejected<>("gateway", Phrase.HTTP_NOT_THROUGH_GATEWAY.with());
    }
    Set<String> taken = takenParking(existing.stream());
    String parking = order.parking();
    if (parking == null) {
      parking =
          floor.parking().stream()
              .map(Place::name)
              .filter(p -> !taken.contains(p))
              .findFirst()
              .orElse(null);
    } else {
      Optional<Sentence> objection = objectionToParking(parking, taken);
      if (objection.isPresent()) {
        return new Answer.Rejected<>("parking", objection.get());
      }
    }
    return new Answer.Accepted<>(
        new RobotRecord(
            order.name(),
            floor.name(),
            order.host(),
            order.port(),
            order.maxLoad(),
            parking,
            false,
            http == null ? null : http.fingerprint(),
            order.gateway(),
            http == null ? null : http.token()));
  }

  Answer<RobotRecord> checkChange(
      RobotRecord robot, RobotChange change, List<RobotRecord> existing) {
    RobotRecord changed = robot.withChange(change);
    if (robot.simulated() && !changed.address().equals(robot.address())) {
      return new Answer.Rejected<>("host", Phrase.SIMULATED_HAS_NO_ADDRESS.with(robot.name()));
    }
    if (!robot.isHttp() && (change.token() != null || change.fingerprint() != null)) {
      return new Answer.Rejected<>("token", Phrase.HAS_NO_TOKEN.with(robot.name()));
    }
    if (robot.isHttp() && change.gateway() != null) {
      return new Answer.Rejected<>("gateway", Phrase.HTTP_NOT_THROUGH_GATEWAY.with());
    }
    Optional<Sentence> ofGateway = objectionToGateway(change.gateway());
    if (ofGateway.isPresent()) {
      return new Answer.Rejected<>("gateway", ofGateway.get());
    }
    Set<String> taken =
        takenParking(existing.stream().filter(other -> !other.name().equals(robot.name())));
    Optional<Sentence> objection =
        Optional.ofNullable(change.parking())
            .flatMap(parking -> objectionToParking(parking, taken));
    return objection.isPresent()
        ? new Answer.Rejected<>("parking", objection.get())
        : new Answer.Accepted<>(changed);
  }

  private Optional<Sentence> objectionToGateway(@Nullable String gateway) {
    return gateway == null || gateways.contains(gateway)
        ? Optional.empty()
        : Optional.of(Phrase.NO_SUCH_GATEWAY.with(gateway));
  }

  private static Set<String> takenParking(Stream<RobotRecord> robots) {
    return robots.map(RobotRecord::parking).filter(p -> p != null).collect(Collectors.toSet());
  }

  private Optional<Sentence> objectionToParking(String parking, Set<String> taken) {
    if (floor.parking().stream().map(Place::name).noneMatch(parking::equals)) {
      return Optional.of(Phrase.NO_SUCH_PARKING.with(parking, names(floor.parking())));
    }
    return taken.contains(parking)
        ? Optional.of(Phrase.PARKING_TAKEN.with(parking))
        : Optional.empty();
  }

  private Answer<TaskPlace> resolvePlace(Phrase end, String field, Where where) {
    return switch (where) {
      case Where.Station(String name) ->
          floor.stations().stream()
              .filter(s -> s.name().equals(name))
              .findFirst()
              .map(s -> checkStandable(end, field, new TaskPlace(s.position(), s.name())))
              .orElseGet(
                  () ->
                      new Answer.Rejected<>(
                          field, Phrase.NO_SUCH_STATION.with(name, names(floor.stations()))));
      case Where.Point(Vec2 position) -> checkStandable(end, field, new TaskPlace(position, null));
      case Where.Charger(String name) -> resolveCharger(field, name, Vec2.ZERO);
    };
  }

  private Answer<TaskPlace> checkStandable(Phrase end, String field, TaskPlace place) {
    return PlaceCheck.objection(floor.grid(), end, place)
        .<Answer<TaskPlace>>map(why -> new Answer.Rejected<>(field, why))
        .orElseGet(() -> new Answer.Accepted<>(place));
  }

  private static Sentence names(List<Place> places) {
    return places.isEmpty()
        ? Phrase.NONE_ON_FLOOR.with()
        : Sentence.names(places.stream().map(Place::name).toList());
  }
}
