package org.toqa.web.input;

import java.time.Instant;
import java.util.Objects;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.TaskOrder;
import org.toqa.mission.OrderPart;

/**
 * Reads the order of a schedule. What it reads means something only where no sentence was filed.
 */
public final class ScheduleReader {
  private static final String MOMENT = "error.schedule.moment";

  private final Fields fields;
  private final Names names;
  private final RecurrenceRules rules;

  private ScheduleReader(Fields fields, Names names, Instant now) {
    this.fields = fields;
    this.names = names;
    this.rules = new RecurrenceRules(fields.texts(), fields.errors(), now);
  }

  private enum Kind {
    ONCE,
    EVERY,
    WEEKLY
  }

  /** What the fields of a recurrence are called, and what tells its kind. */
  private enum Names {
    FORM("first", "first", "weekday", "time") {
      @Override
      Kind kind(Fields fields) {
        return switch (Objects.requireNonNullElse(fields.text("when"), "")) {
          case "every" -> Kind.EVERY;
          case "weekly" -> Kind.WEEKLY;
          default -> Kind.ONCE;
        };
      }
    },
    JSON("at", "from", "weekdays", "zone") {
      @Override
      Kind kind(Fields fields) {
        if (fields.has("everyMinutes")) {
          return Kind.EVERY;
        }
        return fields.has("weekdays") ? Kind.WEEKLY : Kind.ONCE;
      }
    };

    private final String once;
    private final String first;
    private final String weekdays;

    /** The field under which a wrong time zone is filed. */
    private final String zoneField;

    Names(String once, String first, String weekdays, String zoneField) {
      this.once = once;
      this.first = first;
      this.weekdays = weekdays;
      this.zoneField = zoneField;
    }

    abstract Kind kind(Fields fields);
  }

  /** A schedule that a person enters into the form for tasks. */
  public static ScheduleOrder readForm(Fields form, Instant now) {
    PartsOrder order = TaskOrderReader.readEnteredParts(form, now);
    if (order.tasks().size() > 1) {
      String field = order.kind() == OrderPart.Kind.PIECES ? "pieces" : "stop";
      form.errors().add(field, form.texts().get("error.schedule.parts"));
    }
    return new ScheduleReader(form, Names.FORM, now)
        .read(form, OrderedTask.of(order.tasks().getFirst()));
  }

  /** A schedule of a template whose parameters a person has filled in. */
  public static ScheduleOrder readForm(Fields form, OrderedTask task, Instant now) {
    return new ScheduleReader(form, Names.FORM, now).read(form, task);
  }

  /** A schedule that a program gives; the order of its tasks is the object {@code task} in it. */
  public static ScheduleOrder readJson(Fields json, TemplateFiller templates, Instant now) {
    Fields task = json.object("task");
    return new ScheduleReader(json, Names.JSON, now).read(task, templates.read(task));
  }

  /**
   * @param task the fields from which the order was read
   */
  private ScheduleOrder read(Fields task, OrderedTask ordered) {
    TaskOrder order = ordered.order();
    Recurrence recurrence = recurrence();
    Instant until = rules.until("until", fields.moment("until", MOMENT));
    fields.refuseUnknown();
    if (order.deadline() != null) {
      fields
          .errors()
          .add(entered(task, ordered, "deadline"), fields.texts().get("error.schedule.deadline"));
    }
    if (order.arm() != null) {
      fields.errors().add(entered(task, ordered, "arm"), fields.texts().get("error.schedule.arm"));
    }
    return new ScheduleOrder(order, ordered.use(), recurrence, until);
  }

  private static String entered(Fields task, OrderedTask ordered, String field) {
    return task.path(String.valueOf(ordered.entered(field, TemplateFiller.VALUES + ".")));
  }

  private Recurrence recurrence() {
    return switch (names.kind(fields)) {
      case ONCE -> rules.once(names.once, fields.moment(names.once, MOMENT));
      case EVERY ->
          rules.every(
              names.first,
              fields.moment(names.first, MOMENT),
              "everyMinutes",
              fields.number("everyMinutes"));
      case WEEKLY ->
          rules.weekly(
              fields.choices(names.weekdays),
              fields.text("time"),
              names.zoneField,
              fields.text("zone"));
    };
  }
}
