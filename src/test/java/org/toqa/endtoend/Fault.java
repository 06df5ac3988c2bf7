package org.toqa.endtoend;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.toqa.testbed.FaultyTcpProxy;

/**
 * Something that goes wrong at a {@link CrashTestbed}, and is mended.
 *
 * @param delayMillis milliseconds from the one before
 * @param durationMillis milliseconds until it is mended
 */
record Fault(Kind kind, int victim, int delayMillis, int durationMillis) {
  private static final int MAX_DELAY_MS = 3_000;
  private static final int MAX_DURATION_MS = 3_000;

  enum Kind {
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
  static List<Fault> random(RandomGenerator random) {
    List<Fault> cuts = new ArrayList<>();
    for (int i = random.nextInt(3); i >= 0; i--) {
      cuts.add(
          new Fault(
              Kind.values()[random.nextInt(Kind.values().length)],
              random.nextInt(2),
              random.nextInt(MAX_DELAY_MS),
              random.nextInt(MAX_DURATION_MS)));
    }
    return cuts;
  }

  /** Begins it. */
  void inject(CrashTestbed site) throws Exception {
    switch (kind) {
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
  void clear(CrashTestbed site) throws Exception {
    if (kind == Kind.SERVER_KILLED_WHILE_DATABASE_SILENT) {
      site.server.kill();
    }
    site.restoreConnections();
    if (Stream.of(Kind.AGENT_KILLED, Kind.ALL_KILLED).anyMatch(kind::equals)) {
      agent(site).start();
    }
    if (kind.name().contains("SERVER") || kind == Kind.ALL_KILLED) {
      site.server.start();
    }
  }

  private RunningAgent agent(CrashTestbed site) {
    return site.agents.get(victim);
  }

  private FaultyTcpProxy link(CrashTestbed site) {
    return site.links.values().stream().skip(victim).findFirst().orElseThrow();
  }

  @Override
  public String toString() {
    String whose = kind.name().matches("AGENT.*|ALL.*|LINK.*") ? " of robot " + victim : "";
    return "%s%s after %d ms for %d ms"
        .formatted(kind.name().toLowerCase(Locale.ROOT), whose, delayMillis, durationMillis);
  }
}
