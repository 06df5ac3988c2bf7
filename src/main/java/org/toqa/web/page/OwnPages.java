package org.toqa.web.page;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Doors;
import org.toqa.web.Right;

/** The addresses to which a browser may be sent back. */
final class OwnPages {
  private static final Pattern ADDRESS =
      Pattern.compile("(/[A-Za-z0-9._/-]*)(\\?[A-Za-z0-9._~%&=:@+-]*)?");

  private OwnPages() {}

  /** The address, if it is one of our pages. */
  static Optional<String> at(@Nullable String address) {
    Matcher parts = ADDRESS.matcher(address == null ? "" : address);
    return parts.matches() && isPage(parts.group(1))
        ? Optional.of(parts.group())
        : Optional.empty();
  }

  private static boolean isPage(String path) {
    return Doors.at(path)
        .flatMap(place -> place.door("GET"))
        .filter(door -> !door.isApi() && door.right() != Right.ANYBODY)
        .isPresent();
  }
}
