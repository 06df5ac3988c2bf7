package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.web.Texts;

/** Reads from a request's query which users are wanted: by name or e-mail address, and role. */
public final class UserQueryReader {
  private final SearchText text;
  private final @Nullable Role role;

  public UserQueryReader(HttpServletRequest request, FieldErrors errors) {
    QueryFields fields = new QueryFields(request, errors);
    text = SearchText.of(fields);
    String word = fields.text("role");
    Optional<Role> found =
        Arrays.stream(Role.values()).filter(one -> word(one).equals(word)).findFirst();
    if (word != null && found.isEmpty()) {
      String words =
          Arrays.stream(Role.values()).map(UserQueryReader::word).collect(Collectors.joining(", "));
      errors.add("role", Texts.of(request).get("error.users.role", words));
    }
    role = found.orElse(null);
  }

  private static String word(Role role) {
    return role.name().toLowerCase(Locale.ROOT);
  }

  /** Whether not all are wanted. */
  public boolean isFiltered() {
    return text.isGiven() || role != null;
  }

  /** Those of the users that are wanted, in their order. */
  public List<Account> filter(List<Account> all) {
    return all.stream()
        .filter(user -> role == null || user.role() == role)
        .filter(user -> text.isIn(user.name(), user.email()))
        .toList();
  }
}
