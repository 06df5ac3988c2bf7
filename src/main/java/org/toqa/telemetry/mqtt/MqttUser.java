package org.toqa.telemetry.mqtt;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.toqa.telemetry.Topics;

/**
 * Whose connection to the embedded broker it is. What he may do follows from his name alone, so
 * that nobody else's connection, session or client ID changes it.
 */
sealed interface MqttUser {
  /** The names of sites, robots and programs have none of the characters that part them here. */
  Pattern NAME =
      Pattern.compile(
          "([\\p{L}\\p{N}_-]+)/(?:(server)|reader(?:/[A-Za-z0-9._-]{1,64})?|robot/([A-Za-z0-9._-]+))");

  Topics topics();

  /** Whether he may publish to that topic. */
  boolean mayWrite(String topic);

  /**
   * Whether he may subscribe to that filter.
   *
   * @param filter with its wildcards
   */
  boolean mayRead(String filter);

  /** Whether that topic may be of his last will. */
  boolean mayWill(String topic);

  /** Whether the broker may keep what he publishes to that topic for later. */
  boolean mayRetain(String topic);

  /** Publishes readings, and reads what is told of it. */
  record Robot(Topics topics, String name) implements MqttUser {
    @Override
    public boolean mayWrite(String topic) {
      return topics.origin(topic).filter(origin -> origin.robot().equals(name)).isPresent();
    }

    @Override
    public boolean mayRead(String filter) {
      return filter.startsWith(topics.robot(name));
    }

    @Override
    public boolean mayWill(String topic) {
      return isConnection(topic);
    }

    @Override
    public boolean mayRetain(String topic) {
      return isConnection(topic);
    }

    private boolean isConnection(String topic) {
      return topic.equals(topics.robot(name) + Topics.CONNECTION);
    }
  }

  /** Reads everything of its site. */
  record Reader(Topics topics) implements MqttUser {
    @Override
    public boolean mayWrite(String topic) {
      return false;
    }

    @Override
    public boolean mayRead(String filter) {
      return filter.startsWith(topics.prefix());
    }

    @Override
    public boolean mayWill(String topic) {
      return false;
    }

    @Override
    public boolean mayRetain(String topic) {
      return false;
    }
  }

  /** This server's own connection for one of its sites. */
  record Server(Topics topics) implements MqttUser {
    @Override
    public boolean mayWrite(String topic) {
      return topic.startsWith(topics.prefix());
    }

    @Override
    public boolean mayRead(String filter) {
      return filter.startsWith(topics.prefix());
    }

    @Override
    public boolean mayWill(String topic) {
      return topic.equals(topics.server());
    }

    @Override
    public boolean mayRetain(String topic) {
      return true;
    }
  }

  /** Empty: nobody is called so. */
  static Optional<MqttUser> of(String name) {
    Matcher matcher = NAME.matcher(name);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    Topics topics = new Topics(matcher.group(1));
    String robot = matcher.group(3);
    if (robot != null) {
      return Optional.of(new Robot(topics, robot));
    }
    return Optional.of(matcher.group(2) == null ? new Reader(topics) : new Server(topics));
  }
}
