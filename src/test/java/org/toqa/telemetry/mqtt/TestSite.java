package org.toqa.telemetry.mqtt;

import java.nio.charset.StandardCharsets;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Secret;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.telemetry.ReadingBoard;
import org.toqa.telemetry.Topics;
import org.toqa.testbed.MqttTestClient;

/** A site with the robots r1 and r2, its users at an embedded broker, and its connection. */
final class TestSite implements AutoCloseable, EmbeddedBroker.SiteUsers {
  final String name;
  final FeedInMemory feed = new FeedInMemory();
  final ReadingBoard board = new ReadingBoard(List.of("r1", "r2")::contains, (robot, seen) -> {});
  final Map<String, String> passwords = new ConcurrentHashMap<>();
  final String token = Secret.random();
  volatile boolean isTokenValid = true;
  private final Topics topics;
  private @Nullable BrokerConnection connection;

  TestSite(String name) {
    this.name = name;
    this.topics = new Topics(name);
    passwords.put("r1", Secret.random());
    passwords.put("r2", Secret.random());
    feed.set(
        List.of(
            FeedInMemory.robot("r1", RobotState.IDLE), FeedInMemory.robot("r2", RobotState.IDLE)),
        List.of());
  }

  Topics topics() {
    return topics;
  }

  void connect(EmbeddedBroker broker) {
    broker.add(name, this);
    connect(broker.address(), broker.serverUser(name), broker.serverPassword());
  }

  void connect(BrokerAddress address, String user, String password) {
    connection =
        new BrokerConnection(
            address, user, password, topics, board, new Words(), feed, InstantSource.system());
    connection.start();
  }

  BrokerConnection connection() {
    return Objects.requireNonNull(connection);
  }

  String password(String robot) {
    return Objects.requireNonNull(passwords.get(robot));
  }

  boolean isOnline(String robot) {
    ReadingBoard.Presence presence = board.of(robot).presence();
    return presence != null && presence.online();
  }

  MqttTestClient robot(EmbeddedBroker broker, String robot) throws Exception {
    return MqttTestClient.to(broker.address().uri())
        .as(name + "/robot/" + robot, password(robot))
        .connect();
  }

  MqttTestClient reader(EmbeddedBroker broker) throws Exception {
    return MqttTestClient.to(broker.address().uri()).as(name + "/reader", token).connect();
  }

  /** Waits until the server hears what robots publish. */
  void awaitOnline(MqttTestClient reader) throws Exception {
    reader.subscribe(topics.server());
    reader.await(topics.server(), "online"::equals);
  }

  @Override
  public boolean isRobot(String robot, String password) {
    return password.equals(passwords.get(robot));
  }

  @Override
  public OptionalLong reader(String given) {
    return isTokenValid && given.equals(token) ? OptionalLong.of(7) : OptionalLong.empty();
  }

  private static final class Words implements StateWriter {
    @Override
    public byte[] robot(RobotView robot) {
      return robot.state().name().getBytes(StandardCharsets.UTF_8);
    }

    @Override
    public byte[] task(TaskView task) {
      return task.state().name().getBytes(StandardCharsets.UTF_8);
    }
  }

  @Override
  public void close() {
    if (connection != null) {
      connection.close();
    }
  }
}
