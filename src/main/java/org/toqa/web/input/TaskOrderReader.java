package org.toqa.web.input;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskKind;

/** Reads the order of a task. What it reads means something only where no sentence was filed. */
public final class TaskOrderReader {
  private static final Where NOWHERE = new Where.Station("");

  /** What is read where nothing can be. */
  static final TaskOrder NOTHING = new TaskOrder("", 0, NOWHERE, NOWHERE, null, 0, null, null);

  private TaskOrderReader() {}

  /** An order that a program gives: its deadline may have passed already. */
  public static TaskOrder read(Fields fields) {
    return read(fields, deadline -> fields.rules().deadline(fields.path("deadline"), deadline));
  }

  /**
   * An order that a person edits: a deadline that has passed is a slip.
   *
   * @param before its deadline, which counts to the second where the minute is left as it was
   */
  public static TaskOrder readEdited(Fields fields, Instant now, @Nullable Instant before) {
    return read(
        fields,
        deadline ->
            before != null && before.truncatedTo(ChronoUnit.MINUTES).equals(deadline)
                ? before
                : fields.rules().futureDeadline(fields.path("deadline"), deadline, now));
  }

  /**
   * An order of several tasks that a program gives: so many {@code pieces} from start to goal, or
   * one load along its {@code stops}.
   */
  public static PartsOrder readParts(Fields fields) {
    UnaryOperator<@Nullable Instant> deadlineRule =
        deadline -> fields.rules().deadline(fields.path("deadline"), deadline);
    if (!fields.has("stops")) {
      return pieces(
          fields,
          read(fields, () -> fields.place("start"), () -> fields.place("goal"), deadlineRule));
    }
    List<Where> stops = fields.places("stops", PartsOrder.MAX_STOPS);
    if (stops.size() < 2) {
      fields.errors().add(fields.path("stops"), fields.texts().get("error.stops.few"));
    }
    if (fields.has("pieces")) {
      fields.errors().add(fields.path("pieces"), fields.texts().get("error.piecesOrStops"));
    }
    Where start = stops.isEmpty() ? NOWHERE : stops.getFirst();
    return legs(fields, read(fields, () -> start, () -> start, deadlineRule), stops);
  }

  /** The same that a person enters, who says start and goal, and further stops if he wants any. */
  public static PartsOrder readEnteredParts(Fields fields, Instant now) {
    UnaryOperator<@Nullable Instant> deadlineRule =
        deadline -> fields.rules().futureDeadline(fields.path("deadline"), deadline, now);
    if (kind(fields) == TaskKind.DRIVE) {
      return readEnteredDrive(fields, deadlineRule);
    }
    TaskOrder order =
        read(fields, () -> fields.place("start"), () -> fields.place("goal"), deadlineRule);
    List<StopOrder> further = fields.stops("stop", PartsOrder.MAX_STOPS - 2);
    List<StopOrder> way =
        Stream.concat(
                Stream.of(
                    fields.stopAt("start", order.start()), fields.stopAt("goal", order.goal())),
                further.stream())
            .toList();
    boolean hasWaits = way.stream().anyMatch(StopOrder::hasWait);
    PartsOrder pieces = pieces(fields, order);
    if (further.isEmpty() && !hasWaits) {
      return pieces;
    }
    refuseArm(fields, order);
    refuseChargingAt(fields, way, way.size() - 1, fields.path("stop"));
    if (pieces.tasks().size() > 1) {
      fields.errors().add("pieces", fields.texts().get("error.piecesOrStops"));
    }
    return hasWaits || "one".equals(fields.text("carriedBy"))
        ? new PartsOrder(order.name(), OrderPart.Kind.STOPS, List.of(order.along(way)))
        : legs(fields, order, way.stream().map(StopOrder::where).toList());
  }

  /** Its first stop is the goal that was entered. */
  private static PartsOrder readEnteredDrive(
      Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    TaskOrder order = readWithoutLoad(fields, deadlineRule);
    Where goal = fields.place("goal");
    Stream<StopOrder> first =
        Stream.of(
            fields.stopAt(
                "goal", goal instanceof Where.Station(String name) ? StopWords.place(name) : goal));
    List<StopOrder> further = fields.stops("stop", TaskOrder.MAX_STOPS - 1);
    if (fields.rules().pieces(fields.path("pieces"), fields.number("pieces")) > 1) {
      fields.errors().add(fields.path("pieces"), fields.texts().get("error.drive.pieces"));
    }
    return new PartsOrder(
        order.name(),
        OrderPart.Kind.STOPS,
        List.of(order.along(Stream.concat(first, further.stream()).toList())));
  }

  private static TaskKind kind(Fields fields) {
    return fields.rules().taskKind(fields.path("kind"), fields.text("kind"));
  }

  /** An arm handles a load at its start and at its goal alone. */
  private static void refuseArm(Fields fields, TaskOrder order) {
    if (order.arm() != null) {
      fields.errors().add(fields.path("arm"), fields.texts().get("error.arm.stops"));
    }
  }

  /** At these stops a load is picked up or delivered. */
  private static void refuseChargingAt(Fields fields, List<StopOrder> way, int stop, String field) {
    if (!way.isEmpty() && way.get(stop).isCharging()) {
      fields.errors().add(field, fields.texts().get("error.charge.end"));
    }
  }

  private static PartsOrder pieces(Fields fields, TaskOrder piece) {
    int count = fields.rules().pieces(fields.path("pieces"), fields.number("pieces"));
    fields.refuseUnknown();
    return new PartsOrder(piece.name(), OrderPart.Kind.PIECES, Collections.nCopies(count, piece));
  }

  /**
   * @param order whatever is said beside the places
   */
  private static PartsOrder legs(Fields fields, TaskOrder order, List<Where> stops) {
    fields.refuseUnknown();
    refuseArm(fields, order);
    List<TaskOrder> legs =
        IntStream.range(1, stops.size())
            .mapToObj(i -> order.between(stops.get(i - 1), stops.get(i)))
            .toList();
    return new PartsOrder(
        order.name(), OrderPart.Kind.STOPS, legs.isEmpty() ? List.of(order) : legs);
  }

  private static TaskOrder read(Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    if (kind(fields) == TaskKind.DRIVE) {
      return readDrive(fields, deadlineRule);
    }
    if (fields.has("stops")) {
      return readMission(fields, deadlineRule);
    }
    TaskOrder order =
        read(fields, () -> fields.place("start"), () -> fields.place("goal"), deadlineRule);
    fields.refuseUnknown();
    return order;
  }

  /** One robot's way along stops, instead of from start to goal. */
  private static TaskOrder readMission(
      Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    List<StopOrder> stops = fields.stops("stops", TaskOrder.MAX_STOPS);
    if (stops.size() < 2) {
      fields.errors().add(fields.path("stops"), fields.texts().get("error.stops.few"));
    }
    TaskOrder order = read(fields, () -> NOWHERE, () -> NOWHERE, deadlineRule);
    for (String end : List.of("start", "goal")) {
      if (fields.has(end)) {
        fields.place(end); // it is known, and wrong here
        fields.errors().add(fields.path(end), fields.texts().get("error.startOrStops"));
      }
    }
    fields.refuseUnknown();
    refuseArm(fields, order);
    refuseChargingAt(fields, stops, 0, fields.path("stops.0"));
    refuseChargingAt(fields, stops, stops.size() - 1, fields.path("stops." + (stops.size() - 1)));
    return stops.isEmpty() ? order : order.along(stops);
  }

  /** To its goal, or along its stops. */
  private static TaskOrder readDrive(Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    TaskOrder order = readWithoutLoad(fields, deadlineRule);
    List<StopOrder> way;
    if (fields.has("stops")) {
      way = fields.stops("stops", TaskOrder.MAX_STOPS);
      if (way.isEmpty()) {
        fields.errors().add(fields.path("stops"), fields.texts().get("error.drive.stops"));
      }
      if (fields.has("goal")) {
        fields.errors().add(fields.path("goal"), fields.texts().get("error.drive.goal"));
      }
    } else {
      way = List.of(fields.stopAt("goal", fields.place("goal")));
    }
    fields.refuseUnknown();
    return way.isEmpty() ? order : order.along(way);
  }

  /** What is said of a drive beside its places. */
  private static TaskOrder readWithoutLoad(
      Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    InputRules rules = fields.rules();
    TaskOrder order =
        new TaskOrder(
            rules.taskName(fields.path("name"), fields.text("name")),
            0,
            NOWHERE,
            NOWHERE,
            fields.text("floor"),
            rules.priority(fields.path("priority"), fields.number("priority")),
            deadlineRule.apply(fields.moment("deadline", "error.deadline")),
            null,
            rules.robotNames(fields.path("onlyRobots"), fields.choices("onlyRobots")),
            List.of());
    Double load = fields.number("load");
    if (load != null && load != 0) {
      refuse(fields, "load", "error.drive.load");
    }
    if (fields.size("size") != null) {
      refuse(fields, "size", "error.drive.load");
    }
    if (fields.arm("arm") != null) {
      refuse(fields, "arm", "error.drive.load");
    }
    if (fields.hasPlace("start")) {
      refuse(fields, "start", "error.drive.start");
    }
    return order;
  }

  private static void refuse(Fields fields, String field, String key) {
    fields.errors().add(fields.path(field), fields.texts().get(key));
  }

  /** The sentences are in the order of the columns of a table. */
  private static TaskOrder read(
      Fields fields,
      Supplier<Where> start,
      Supplier<Where> goal,
      UnaryOperator<@Nullable Instant> deadlineRule) {
    InputRules rules = fields.rules();
    return new TaskOrder(
        rules.taskName(fields.path("name"), fields.text("name")),
        rules.load(fields.path("load"), fields.number("load")),
        start.get(),
        goal.get(),
        fields.text("floor"),
        rules.priority(fields.path("priority"), fields.number("priority")),
        deadlineRule.apply(fields.moment("deadline", "error.deadline")),
        fields.size("size"),
        rules.robotNames(fields.path("onlyRobots"), fields.choices("onlyRobots")),
        List.of(),
        fields.arm("arm"));
  }
}
