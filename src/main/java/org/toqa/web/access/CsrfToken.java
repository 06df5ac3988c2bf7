package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpSession;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import org.jspecify.annotations.Nullable;

/**
 * The secret of a session that its own pages send back with every write (synchronizer token
 * pattern).
 */
public final class CsrfToken {
  /** The name of the hidden field in every form. */
  public static final String FIELD = "_csrf";

  /** The header that carries it where there is no form. */
  public static final String HEADER = "X-CSRF-Token";

  private static final String ATTRIBUTE = CsrfToken.class.getName();
  private static final int RANDOM_BYTES = 24;
  private static final SecureRandom RANDOM = new SecureRandom();

  private CsrfToken() {}

  /** The session's token; makes both if there is none. */
  public static String of(HttpServletRequest request) {
    HttpSession session = request.getSession();
    if (session.getAttribute(ATTRIBUTE) instanceof String token) {
      return token;
    }
    return renew(session);
  }

  static String renew(HttpSession session) {
    byte[] secret = new byte[RANDOM_BYTES];
    RANDOM.nextBytes(secret);
    String token = Base64.getUrlEncoder().withoutPadding().encodeToString(secret);
    session.setAttribute(ATTRIBUTE, token);
    return token;
  }

  static boolean matches(HttpServletRequest request, @Nullable String given) {
    HttpSession session = request.getSession(false);
    return given != null
        && session != null
        && session.getAttribute(ATTRIBUTE) instanceof String token
        && MessageDigest.isEqual(
            token.getBytes(StandardCharsets.UTF_8), given.getBytes(StandardCharsets.UTF_8));
  }
}
