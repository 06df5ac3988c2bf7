package org.toqa.road;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.toqa.testbed.Cable;

/**
 * Something that goes wrong at a {@link CrashSite}, and is mended.
 *
 * @param after milliseconds from the one before
 * @param lasts milliseconds until it is mended
 */
record Cut(What what, int victim, int after, int lasts) {
  private static final int LATEST = 3_000;
  private static final int LONGEST = 3_000;

  enum What {
    SERVER_KILLED,
    AGENT_KILLED,
    ALL_KILLED,
    DATABASE_CUT,
    DATABASE_SILENT,
    SERVER_KILLED_WHILE_DATABASE_SILENT,
    LINK_CUT,
    LINK_SILENT
  }

  /** One, two or three of them. */
  static List<Cut> random(RandomGenerator random) {
    List<Cut> cuts = new ArrayList<>();
    for (int i = random.nextInt(3); i >= 0; i--) {
      cuts.add(
          new Cut(
              What.values()[random.nextInt(What.values().length)],
              random.nextInt(2),
              random.nextInt(LATEST),
              random.nextInt(LONGEST)));
    }
    return cuts;
  }

  /** Begins it. */
  void strike(CrashSite site) throws Exception {
    switch (what) {
      case SERVER_KILLED -> site.server.kill();
      case AGENT_KILLED -> agent(site).kill();
      case ALL_KILLED -> {
        agent(site).kill();
        site.server.kill();
      }
      case DATABASE_CUT -> site.database.cut();
      case DATABASE_SILENT, SERVER_KILLED_WHILE_DATABASE_SILENT -> site.database.silence();
      case LINK_CUT -> link(site).cut();
      case LINK_SILENT -> link(site).silence();
    }
  }

  /** Ends it. */
  void mend(CrashSite site) throws Exception {
    if (what == What.SERVER_KILLED_WHILE_DATABASE_SILENT) {
      site.server.kill();
    }
    site.mendAll();
    if (Stream.of(What.AGENT_KILLED, What.ALL_KILLED).anyMatch(what::equals)) {
      agent(site).startAgain();
    }
    if (what.name().contains("SERVER") || what == What.ALL_KILLED) {
      site.server.startAgain();
    }
  }

  private RunningAgent agent(CrashSite site) {
    return site.agents.get(victim);
  }

  private Cable link(CrashSite site) {
    return site.links.values().stream().skip(victim).findFirst().orElseThrow();
  }

  @Override
  public String toString() {
    String whose = what.name().matches("AGENT.*|ALL.*|LINK.*") ? " of robot " + victim : "";
    return "%s%s after %d ms for %d ms"
        .formatted(what.name().toLowerCase(Locale.ROOT), whose, after, lasts);
  }
}
