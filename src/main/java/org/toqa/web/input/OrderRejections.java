package org.toqa.web.input;

import java.util.List;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.TaskView;
import org.toqa.mission.OrderPart;
import org.toqa.web.Texts;

/** What the fleet says against the tasks of an order, filed under the fields of that order. */
public final class OrderRejections {
  private final OrderPart.Kind kind;
  private final boolean isForm;
  private final Texts texts;

  private OrderRejections(OrderPart.Kind kind, boolean isForm, Texts texts) {
    this.kind = kind;
    this.isForm = isForm;
    this.texts = texts;
  }

  /** Of an order that a program gave. */
  public static OrderRejections ofJson(OrderPart.Kind kind, Texts texts) {
    return new OrderRejections(kind, false, texts);
  }

  /** Of one that a person entered. */
  public static OrderRejections ofForm(OrderPart.Kind kind, Texts texts) {
    return new OrderRejections(kind, true, texts);
  }

  /** The tasks; where there are none the errors say why. */
  public List<TaskView> accepted(BatchAnswer answer, FieldErrors errors) {
    return switch (answer) {
      case BatchAnswer.Accepted(List<TaskView> tasks) -> tasks;
      case BatchAnswer.Rejected(List<BatchAnswer.Rejection> rejections) -> {
        for (BatchAnswer.Rejection rejection : rejections) {
          errors.add(field(rejection), texts.text(rejection.sentence()));
        }
        yield List.of();
      }
    };
  }

  /** Legs have two stops each; what is wrong with a stop is wrong with two legs. */
  private String field(BatchAnswer.Rejection rejection) {
    String field = rejection.field() == null ? "form" : rejection.field();
    boolean isPlace = field.equals("start") || field.equals("goal");
    if (kind == OrderPart.Kind.PIECES || !isPlace) {
      return field;
    }
    int stop = rejection.index() + (field.equals("goal") ? 1 : 0);
    if (!isForm) {
      return "stops." + stop;
    }
    return entered(stop, "stop");
  }

  /**
   * The field in which a person says a stop, whose first two are start and goal.
   *
   * @param stop from 0
   * @param further the field of all others
   */
  public static String entered(int stop, String further) {
    return switch (stop) {
      case 0 -> "start";
      case 1 -> "goal";
      default -> further;
    };
  }
}
