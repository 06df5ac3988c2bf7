package org.toqa.endtoend;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.toqa.testbed.FaultyTcpProxy;

/**
 * Something that goes wrong at a {@link CrashTestbed}, and is mended.
 *
 * @param delayMillis milliseconds from the one before
 * @param durationMillis milliseconds until it is mended, at least
 * @param bytes after so many a connection is cut
 */
record Fault(Kind kind, int victim, int delayMillis, int durationMillis, int bytes) {
  private static final int MAX_DELAY_MS = 1_000;
  private static final int MAX_DURATION_MS = 1_500;

  /** As much as an import of a few tasks takes. */
  private static final int MAX_BYTES = 15_000;

  private static final int MAX_IMPORT_MS = 60;

  enum Kind {
    SERVER_KILLED,
    AGENT_KILLED,
    ALL_KILLED,
    DATABASE_CUT,
    DATABASE_SILENT,
    SERVER_KILLED_WHILE_DATABASE_SILENT,
    LINK_CUT,
    LINK_SILENT,
    AGENT_FROZEN,
    SERVER_RESTARTED_WHILE_AGENTS_FROZEN
  }

  private static final Set<Kind> SERVER_IS_DEAD =
      EnumSet.of(Kind.SERVER_KILLED, Kind.ALL_KILLED, Kind.SERVER_KILLED_WHILE_DATABASE_SILENT);

  static List<Fault> random(int number, RandomGenerator random) {
    List<Fault> cuts = new ArrayList<>();
    for (int i = 0; i < number; i++) {
      cuts.add(
          new Fault(
              Kind.values()[random.nextInt(Kind.values().length)],
              random.nextInt(2),
              random.nextInt(MAX_DELAY_MS),
              random.nextInt(MAX_DURATION_MS),
              random.nextInt(MAX_BYTES)));
    }
    return cuts;
  }

  /** How long after an import has begun; a cut that counts the import's bytes comes first. */
  int millisIntoImport() {
    return kind == Kind.DATABASE_CUT ? 0 : bytes % MAX_IMPORT_MS;
  }

  /**
   * Whether it lasts until people are answered: every second database is away for longer than
   * anybody waits for it. The others answer again while somebody waits, or their server is killed.
   */
  boolean isUntilAnswered() {
    return (kind == Kind.DATABASE_CUT || kind == Kind.DATABASE_SILENT) && victim == 0;
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
      case DATABASE_CUT -> site.database.cutAfter(bytes);
      case DATABASE_SILENT, SERVER_KILLED_WHILE_DATABASE_SILENT -> site.database.silence();
      case LINK_CUT -> link(site).cut();
      case LINK_SILENT -> link(site).silence();
      case AGENT_FROZEN -> agent(site).freeze();
      case SERVER_RESTARTED_WHILE_AGENTS_FROZEN -> {
        for (RunningAgent agent : site.agents) {
          agent.freeze();
        }
        site.server.killAndRestart();
      }
    }
  }

  /** Ends it. */
  void clear(CrashTestbed site) throws Exception {
    if (kind == Kind.SERVER_KILLED_WHILE_DATABASE_SILENT) {
      site.server.kill();
    }
    site.restoreConnections();
    if (kind == Kind.AGENT_FROZEN) {
      agent(site).thaw();
    }
    if (kind == Kind.SERVER_RESTARTED_WHILE_AGENTS_FROZEN) {
      for (RunningAgent agent : site.agents) {
        agent.thaw();
      }
    }
    if (Stream.of(Kind.AGENT_KILLED, Kind.ALL_KILLED).anyMatch(kind::equals)) {
      agent(site).start();
    }
    if (SERVER_IS_DEAD.contains(kind)) {
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
    String whose = kind.name().matches("AGENT_.*|ALL.*|LINK.*") ? " of robot " + victim : "";
    return "%s%s after %d ms for %d ms"
        .formatted(kind.name().toLowerCase(Locale.ROOT), whose, delayMillis, durationMillis);
  }
}
