package org.toqa.web.page;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import jakarta.servlet.ServletContext;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import org.toqa.web.access.Caller;

/**
 * Secrets that were just made and that the next page of the same session shows, once: between a
 * form and the page that its answer leads to, so that a reload makes no second one.
 */
public final class ShownOnce {
  /** The servlet context's attribute that holds them. */
  public static final String ATTRIBUTE = ShownOnce.class.getName();

  private static final Duration LIFETIME = Duration.ofMinutes(5);
  private static final int MAX_ENTRIES = 1000;

  private final Cache<Key, String> secrets =
      Caffeine.newBuilder()
          .maximumSize(MAX_ENTRIES)
          .expireAfterWrite(LIFETIME)
          .executor(Runnable::run)
          .build();

  /**
   * @param site the id of its maker's site
   * @param session the id of the session that made it
   * @param name of what it is
   */
  private record Key(long site, long session, String name) {}

  static ShownOnce of(ServletContext context) {
    return (ShownOnce) Objects.requireNonNull(context.getAttribute(ATTRIBUTE));
  }

  void put(Caller caller, String name, String secret) {
    secrets.put(new Key(caller.site().id(), caller.session().id(), name), secret);
  }

  /** The secret, if there is one that was not shown yet. */
  Optional<String> take(Caller caller, String name) {
    return Optional.ofNullable(
        secrets.asMap().remove(new Key(caller.site().id(), caller.session().id(), name)));
  }
}
