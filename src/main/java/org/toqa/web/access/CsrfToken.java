package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Secret;

/**
 * What a browser's own pages send back with every write. It follows from the secret of {@link
 * SessionCookie}, which other sites can neither read nor, from the token, find out.
 */
public final class CsrfToken {
  /** The name of the hidden field in every form. */
  public static final String FIELD = "_csrf";

  /** The header that carries it where there is no form. */
  public static final String HEADER = "X-CSRF-Token";

  private CsrfToken() {}

  /** The browser's token; makes its cookie if there is none. */
  public static String of(HttpServletRequest request, HttpServletResponse response) {
    return from(SessionCookie.getOrCreate(request, response));
  }

  public static boolean isValid(HttpServletRequest request, @Nullable String given) {
    return given != null
        && SessionCookie.of(request)
            .filter(
                secret ->
                    MessageDigest.isEqual(
                        from(secret).getBytes(StandardCharsets.UTF_8),
                        given.getBytes(StandardCharsets.UTF_8)))
            .isPresent();
  }

  private static String from(String secret) {
    return Secret.hash("csrf " + secret);
  }
}
