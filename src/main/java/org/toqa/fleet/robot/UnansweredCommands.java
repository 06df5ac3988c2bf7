package org.toqa.fleet.robot;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;

/** The commands that were sent over a connection and that the robot has not answered. */
final class UnansweredCommands {
  /** A robot that answers nothing is told so many at most that are remembered. */
  private static final int MAX = 1_000;

  /** By the commands' numbers: the drive that the command is to change, if it is such a one. */
  private final Map<Long, OptionalLong> drives = new LinkedHashMap<>();

  void add(Command command) {
    drives.put(
        command.seq(),
        switch (command) {
          case ServerMessage.Extend extend -> OptionalLong.of(extend.drive());
          case ServerMessage.Release release -> OptionalLong.of(release.drive());
          default -> OptionalLong.empty();
        });
    if (drives.size() > MAX) {
      Iterator<Long> oldest = drives.keySet().iterator();
      oldest.next();
      oldest.remove();
    }
  }

  /**
   * The command of that number is answered.
   *
   * @return the drive that it is to change, if it is such a one; empty: no such command waits for
   *     an answer
   */
  Optional<OptionalLong> take(long seq) {
    return Optional.ofNullable(drives.remove(seq));
  }

  void clear() {
    drives.clear();
  }
}
