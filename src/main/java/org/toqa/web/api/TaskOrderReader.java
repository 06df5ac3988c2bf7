package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/** Reads a task order from the wire. */
final class TaskOrderReader {
  private final JsonFields fields;
  private final InputRules rules;
  private final FieldErrors errors;
  private final Texts texts;

  private TaskOrderReader(JsonFields fields, InputRules rules, FieldErrors errors, Texts texts) {
    this.fields = fields;
    this.rules = rules;
    this.errors = errors;
    this.texts = texts;
  }

  /**
   * @throws Problem.ProblemException with a sentence for each field that is wrong
   */
  static TaskOrder read(HttpServletRequest request) throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    Texts texts = Texts.of(request);
    TaskOrder order =
        new TaskOrderReader(fields, new InputRules(texts, errors), errors, texts).read();
    ApiHandler.throwIfAny(errors);
    return order;
  }

  /** The order in that field. It means something only when no error was filed. */
  static TaskOrder read(String name, JsonFields fields, Texts texts, FieldErrors errors) {
    Optional<JsonFields> order = fields.object(name);
    if (order.isEmpty()) {
      errors.add(name, texts.get("error.type.object", name));
      Where nowhere = new Where.Station("");
      return new TaskOrder("", 0, nowhere, nowhere, null, 0, null, null);
    }
    return new TaskOrderReader(order.get(), new InputRules(texts, errors), errors, texts).read();
  }

  private TaskOrder read() {
    TaskOrder order =
        new TaskOrder(
            rules.taskName(fields.path("name"), fields.text("name")),
            rules.load(fields.path("load"), fields.number("load")),
            where("start"),
            where("goal"),
            fields.text("floor"),
            rules.priority(fields.path("priority"), fields.number("priority")),
            deadline(),
            size());
    fields.refuseUnknown();
    return order;
  }

  private Where where(String name) {
    Optional<JsonFields> place = fields.object(name);
    if (place.isEmpty()) {
      errors.add(fields.path(name), texts.get("error.place.missing", name));
      return new Where.Station("");
    }
    return where(name, place.get());
  }

  private Where where(String name, JsonFields place) {
    String station = place.text("station");
    if (!place.has("station")) {
      Vec2 position =
          new Vec2(
              rules.coordinate(place.path("x"), place.number("x")),
              rules.coordinate(place.path("y"), place.number("y")));
      place.refuseUnknown();
      return new Where.Point(position);
    }
    if (station == null || place.has("x") || place.has("y")) {
      errors.add(fields.path(name), texts.get("error.place.missing", name));
    } else {
      place.refuseUnknown();
    }
    return new Where.Station(station == null ? "" : station);
  }

  private @Nullable Instant deadline() {
    String given = fields.text("deadline");
    if (given == null) {
      return null;
    }
    try {
      return rules.deadline(fields.path("deadline"), OffsetDateTime.parse(given).toInstant());
    } catch (DateTimeException e) {
      errors.add(fields.path("deadline"), texts.get("error.deadline"));
      return null;
    }
  }

  private @Nullable LoadSize size() {
    return fields
        .object("size")
        .map(
            size -> {
              LoadSize read =
                  rules.size(fields.path("size"), size.number("length"), size.number("width"));
              size.refuseUnknown();
              return read;
            })
        .orElse(null);
  }
}
