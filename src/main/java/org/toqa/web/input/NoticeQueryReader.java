package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import org.toqa.notices.NoticeStore.Filter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** Which notices are wanted: {@code show} is {@code all}, {@code open} or {@code unseen}. */
public final class NoticeQueryReader {
  private final HttpServletRequest request;
  private final FieldErrors errors;
  private final QueryFields fields;

  public NoticeQueryReader(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
    this.fields = new QueryFields(request, errors);
  }

  /** Each case is a word of {@code show}. */
  public enum Show {
    ALL,
    OPEN,
    UNSEEN
  }

  public Show show() {
    String given = fields.text("show");
    if (given == null) {
      return Show.ALL;
    }
    return switch (given) {
      case "all" -> Show.ALL;
      case "open" -> Show.OPEN;
      case "unseen" -> Show.UNSEEN;
      default -> {
        errors.add("show", Texts.of(request).get("error.notices.show"));
        yield Show.ALL;
      }
    };
  }

  /** It means something only when no error was filed. */
  public Filter filter() {
    Show show = show();
    return new Filter(
        show == Show.OPEN, show == Show.UNSEEN ? Caller.of(request).account().id() : null);
  }

  /** The id of the notice before which it begins. */
  public long before() {
    Long before = fields.number("before");
    return before == null ? Long.MAX_VALUE : before;
  }
}
