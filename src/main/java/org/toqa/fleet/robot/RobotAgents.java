package org.toqa.fleet.robot;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.Extension;
import org.apache.pekko.actor.typed.ExtensionId;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotRecord;

/**
 * The agents of all robots of one system, for what must not wait until a floor is ready: robots are
 * pinged, and put on hold, however long its planning takes. Any thread may call it.
 */
public final class RobotAgents implements Extension {
  private static final ExtensionId<RobotAgents> ID =
      new ExtensionId<>() {
        @Override
        public RobotAgents createExtension(ActorSystem<?> system) {
          return new RobotAgents();
        }
      };

  private final Map<ActorRef<RobotMessage>, Entry> agents = new ConcurrentHashMap<>();
  private final Map<String, ActorRef<RobotMessage>> byRobot = new ConcurrentHashMap<>();

  /**
   * @param dueTick the time that it was told and has not taken yet
   */
  private record Entry(RobotRecord robot, AtomicReference<@Nullable Instant> dueTick) {}

  private RobotAgents() {}

  public static RobotAgents of(ActorSystem<?> system) {
    return system.registerExtension(ID);
  }

  void add(RobotRecord robot, ActorRef<RobotMessage> agent) {
    agents.put(agent, new Entry(robot, new AtomicReference<>()));
    byRobot.put(robot.name(), agent);
  }

  void remove(ActorRef<RobotMessage> agent) {
    agents.remove(agent);
    byRobot.values().remove(agent);
  }

  /** Tells the robot's agent; nothing where there is none. */
  public void tell(String robot, RobotMessage message) {
    ActorRef<RobotMessage> agent = byRobot.get(robot);
    if (agent != null) {
      agent.tell(message);
    }
  }

  /** Time goes on: they ping their robots, and notice who is silent. */
  public void tick(Instant now) {
    agents.forEach(
        (agent, entry) -> {
          AtomicReference<@Nullable Instant> due = entry.dueTick();
          if (due.getAndSet(now) == null) { // ticks never pile up before it
            agent.tell(new RobotMessage.Tick(() -> requireNonNull(due.getAndSet(null))));
          }
        });
  }

  /** Robots hold at once. Tell their floor first: it lets go on whoever holds without its word. */
  public void hold(Predicate<RobotRecord> robots) {
    agents.forEach(
        (agent, entry) -> {
          if (robots.test(entry.robot())) {
            agent.tell(new RobotMessage.Hold(true));
          }
        });
  }
}
