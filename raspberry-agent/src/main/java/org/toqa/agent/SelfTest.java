package org.toqa.agent;

import java.util.Locale;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.control.RobotReport;
import org.toqa.link.message.AgentMessage.Fault;

/**
 * Logs the state in which a robot is found when its daemon has started: whoever installs it need
 * not wait for a server to see what is wrong.
 */
final class SelfTest {
  /** Until then a body has answered and what the daemon may clear is cleared: 200 ms. */
  static final int TICKS = 10;

  private static final Logger log = LoggerFactory.getLogger(SelfTest.class);

  private SelfTest() {}

  static void logResult(RobotReport robot) {
    String name = robot.config().name();
    String found =
        String.format(
            Locale.ROOT,
            "battery %.0f %%, %d range sensors, %s",
            100 * robot.reading().battery(),
            robot.reading().ranges().size(),
            robot.isLocalised() ? "knows where it is" : "does not know where it is");
    String said = robot.errors().stream().map(Fault::text).collect(Collectors.joining(" "));
    if (!robot.reading().faults().isEmpty()) {
      log.warn("{}: self-test failed: {} ({}).", name, said, found);
    } else if (robot.errors().isEmpty()) {
      log.info("{}: self-test passed: {}.", name, found);
    } else { // what it was told or did before has nothing to do with its body
      log.info("{}: self-test passed: {}. {}", name, found, said);
    }
  }
}
