package org.toqa.web;

import jakarta.servlet.ServletContext;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Site;
import org.toqa.fleet.Answer;

/**
 * The sites that share this server. Whoever starts the web application puts this into the servlet
 * context. Any thread may ask.
 */
public interface Sites {
  /** No name with its site is longer. */
  int LONGEST_LOGIN = 200;

  /** From little to much. */
  List<String> LOG_LEVELS = List.of("ERROR", "WARN", "INFO", "DEBUG", "TRACE");

  /** How long a site may take to be made: its database is, on a small computer. */
  Duration ADD_LIMIT = Duration.ofMinutes(2);

  /** The servlet context's attribute that holds the sites. */
  String ATTRIBUTE = Sites.class.getName();

  /** Of the site whose users log in by their name alone. */
  Services first();

  /** Of the site with that id; empty: there is none, or it cannot be used now. */
  Optional<Services> find(long id);

  /** Of the site of that name in any case; empty: there is none, or it cannot be used now. */
  Optional<Services> find(String name);

  /** Of all that can be used now. */
  List<Services> running();

  /** All of them, the first one first. */
  List<SiteSummary> all();

  /**
   * Makes a site with its first manager.
   *
   * @param by who does it
   */
  CompletionStage<Answer<SiteSummary>> add(
      String name, String manager, String passwordHash, String by);

  /**
   * Ends a site that has neither robots nor open tasks. What it has stored is kept where it is.
   *
   * @param by who does it
   * @return its name
   */
  CompletionStage<Answer<String>> remove(String name, String by);

  /** How the whole server is configured, without what is secret. */
  List<ServerSetting> settings();

  /** How much is logged now: one of {@link #LOG_LEVELS}. */
  String logLevel();

  /**
   * From now on, until the server ends, so much is logged.
   *
   * @param level one of {@link #LOG_LEVELS}
   * @param by who does it
   */
  void changeLogLevel(String level, String by);

  /** Of the site that gave out that secret; of the first one where there is none of that site. */
  default Services ofSecret(String secret) {
    return find(Secret.site(secret)).orElseGet(this::first);
  }

  /**
   * Who wants to log in.
   *
   * @param site of the site where he is looked for
   * @param name as that site may know it
   */
  record Login(Services site, String name) {}

  /** {@code NAME}, or {@code NAME@SITE}; in the first site a name may have an @ itself. */
  default Login login(String typed) {
    String given = typed.strip();
    int at = given.length() > LONGEST_LOGIN ? -1 : given.lastIndexOf('@');
    if (at > 0 && first().accounts().accountByName(given).isEmpty()) {
      Optional<Services> named = find(Site.key(given.substring(at + 1)));
      if (named.isPresent()) {
        return new Login(named.get(), given.substring(0, at).strip());
      }
    }
    return new Login(first(), given);
  }

  /**
   * Sends a link to replace the password to whom that may be: the user of that name, or all of that
   * e-mail address.
   *
   * @param typed {@code NAME}, {@code NAME@SITE} or an e-mail address
   * @param address where the request comes from
   * @return zero, or how long until the next request is looked at
   */
  default Duration sendPasswordLink(String typed, String address, Texts texts) {
    Login who = login(typed);
    Duration wait = who.site().passwordLinks().sendLink(who.name(), address, texts);
    if (wait.isZero() && who.site().site().isFirst() && who.name().contains("@")) {
      for (Services other : running()) {
        if (!other.site().isFirst()) {
          other.passwordLinks().sendLink(who.name(), address, texts);
        }
      }
    }
    return wait;
  }

  static Sites of(ServletContext context) {
    return (Sites)
        Objects.requireNonNull(
            context.getAttribute(ATTRIBUTE), "The sites are not in the servlet context.");
  }
}
