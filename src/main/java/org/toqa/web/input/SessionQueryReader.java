package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Session;

/**
 * Reads from a request's query which sessions of a user are wanted: of what kind, and by the name
 * of a token, the address or the program. A kind that there is not is as none.
 */
public final class SessionQueryReader {
  private final SearchText text;
  private final Session.@Nullable Kind kind;

  public SessionQueryReader(HttpServletRequest request) {
    QueryFields fields = new QueryFields(request, new FieldErrors());
    text = SearchText.of(fields);
    String word = fields.text("kind");
    kind =
        Arrays.stream(Session.Kind.values())
            .filter(one -> one.name().toLowerCase(Locale.ROOT).equals(word))
            .findFirst()
            .orElse(null);
  }

  /** Whether not all are wanted. */
  public boolean isFiltered() {
    return text.isGiven() || kind != null;
  }

  /** Those of the sessions that are wanted, in their order. */
  public List<Session> filter(List<Session> all) {
    return all.stream()
        .filter(session -> kind == null || session.kind() == kind)
        .filter(
            session ->
                text.isIn(session.name(), session.origin().address(), session.origin().agent()))
        .toList();
  }
}
