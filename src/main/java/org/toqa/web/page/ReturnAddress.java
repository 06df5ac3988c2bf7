package org.toqa.web.page;

import jakarta.servlet.ServletRequest;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.web.PagePaths;

/** The addresses to which a browser may be sent back. */
final class ReturnAddress {
  private static final Pattern ADDRESS =
      Pattern.compile("(/[A-Za-z0-9._/-]*)(\\?[A-Za-z0-9._~%&=:@+-]*)?");

  private ReturnAddress() {}

  /** The address, if it is one of our pages. */
  static Optional<String> parse(ServletRequest request, @Nullable String address) {
    Matcher parts = ADDRESS.matcher(address == null ? "" : address);
    return parts.matches() && PagePaths.of(request.getServletContext()).contains(parts.group(1))
        ? Optional.of(parts.group())
        : Optional.empty();
  }
}
