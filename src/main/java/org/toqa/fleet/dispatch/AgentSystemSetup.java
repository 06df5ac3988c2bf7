package org.toqa.fleet.dispatch;

import com.typesafe.config.Config;
import com.typesafe.config.ConfigFactory;
import org.apache.pekko.actor.BootstrapSetup;
import org.toqa.fleet.FleetRuntime;
import scala.concurrent.ExecutionContext;

/** How the system of agents is made. */
public final class AgentSystemSetup {
  /** Mailboxes let pauses and floors' holds overtake all else. */
  private static final Config CONFIG =
      ConfigFactory.parseString(
          """
          pekko {
            actor.typed.default-mailbox.mailbox-type =
              "org.apache.pekko.dispatch.UnboundedControlAwareMailbox"
            loggers = ["org.apache.pekko.event.slf4j.Slf4jLogger"]
            logging-filter = "org.apache.pekko.event.slf4j.Slf4jLoggingFilter"
            loglevel = "WARNING"
            stdout-loglevel = "OFF"
            log-dead-letters = off
            log-dead-letters-during-shutdown = off
            jvm-exit-on-fatal-error = off
            coordinated-shutdown.run-by-jvm-shutdown-hook = off
          }
          """);

  private AgentSystemSetup() {}

  /** For agents that run on what the runtime hands in. */
  public static BootstrapSetup of(FleetRuntime runtime) {
    ClassLoader loader = AgentSystemSetup.class.getClassLoader();
    BootstrapSetup setup =
        BootstrapSetup.create(CONFIG.withFallback(ConfigFactory.load(loader)))
            .withClassloader(loader);
    return runtime
        .agentExecutor()
        .map(ExecutionContext::fromExecutor)
        .map(setup::withDefaultExecutionContext)
        .orElse(setup);
  }
}
