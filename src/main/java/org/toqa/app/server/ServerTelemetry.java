package org.toqa.app.server;

import java.io.IOException;
import java.time.InstantSource;
import java.util.Deque;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Secret;
import org.toqa.accounts.Session;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.localisation.GridWalls;
import org.toqa.localisation.Walls;
import org.toqa.telemetry.Telemetry;
import org.toqa.telemetry.TelemetryStore;
import org.toqa.telemetry.Topics;
import org.toqa.telemetry.mqtt.BrokerAddress;
import org.toqa.telemetry.mqtt.BrokerConnection;
import org.toqa.telemetry.mqtt.BrokerDoor;
import org.toqa.telemetry.mqtt.BrokerSettings;
import org.toqa.telemetry.mqtt.EmbeddedBroker;
import org.toqa.telemetry.mqtt.StateWriter;
import org.toqa.web.api.Json;
import org.toqa.web.api.RobotJson;
import org.toqa.web.api.TaskJson;
import tools.jackson.databind.ObjectWriter;

/**
 * MQTT for all sites: one broker, and a connection to it for each of them.
 *
 * @param broker this process's own; null: there is none, or it is another one
 * @param external null: there is none
 */
record ServerTelemetry(@Nullable EmbeddedBroker broker, BrokerSettings.@Nullable External external)
    implements AutoCloseable {

  /**
   * @param settings null: no port is opened and no broker is asked
   * @param door by which connections come to the embedded broker
   * @throws IOException the embedded broker cannot start; the message says what to do
   */
  static ServerTelemetry start(@Nullable BrokerSettings settings, BrokerDoor door)
      throws IOException {
    return switch (settings) {
      case null -> new ServerTelemetry(null, null);
      case BrokerSettings.Embedded embedded -> {
        BrokerSettings.PemFiles tls = embedded.tls();
        if (tls != null) {
          CertificateWithKey.read("mqtt", tls.certificate(), tls.key());
        }
        yield new ServerTelemetry(EmbeddedBroker.start(embedded, door), null);
      }
      case BrokerSettings.External external -> new ServerTelemetry(null, external);
    };
  }

  /**
   * Begins to hear and publish for a site.
   *
   * @param ranges gets those that its robots publish
   * @param parts gets what is to be closed
   * @return null: there is no broker
   * @throws IOException the certificates of an external broker cannot be used
   */
  @Nullable Telemetry open(
      Site site,
      AgentFleet fleet,
      PublishedRanges ranges,
      TelemetryStore store,
      SessionStore sessions,
      InstantSource clock,
      Deque<AutoCloseable> parts)
      throws IOException {
    EmbeddedBroker own = broker;
    if (own != null) {
      Telemetry telemetry = telemetry(site, own.address(), true, fleet, ranges, store, clock);
      own.add(site.name(), new Users(site, telemetry, sessions));
      parts.push(() -> own.remove(site.name()));
      connect(
          site,
          own.address(),
          own.serverUser(site.name()),
          own.serverPassword(),
          telemetry,
          fleet,
          clock,
          parts);
      return telemetry;
    }
    if (external == null) {
      return null;
    }
    BrokerAddress address = BrokerAddress.of(external);
    Telemetry telemetry = telemetry(site, address, false, fleet, ranges, store, clock);
    connect(site, address, external.user(), external.password(), telemetry, fleet, clock, parts);
    return telemetry;
  }

  private static Telemetry telemetry(
      Site site,
      BrokerAddress address,
      boolean isEmbedded,
      AgentFleet fleet,
      PublishedRanges ranges,
      TelemetryStore store,
      InstantSource clock) {
    Telemetry telemetry =
        new Telemetry(
            site.name(),
            new Telemetry.BrokerPlace(address.shown(), isEmbedded),
            new RobotNames(fleet.snapshots()),
            (robot, seen) -> {
              fleet.tellRanges(robot, seen.values(), seen.angles());
              ranges.put(robot, seen.values(), seen.angles(), () -> walls(fleet, robot));
            },
            store,
            clock);
    fleet.addRobotCheck(telemetry::alerts);
    return telemetry;
  }

  private static Optional<Walls> walls(AgentFleet fleet, String robot) {
    return fleet.snapshots().latest().robots().stream()
        .filter(view -> view.name().equals(robot))
        .findFirst()
        .flatMap(
            view ->
                fleet.floors().stream()
                    .filter(floor -> floor.name().equals(view.floor()))
                    .findFirst())
        .map(floor -> new GridWalls(floor.drawing().walls()));
  }

  private static void connect(
      Site site,
      BrokerAddress address,
      @Nullable String user,
      @Nullable String password,
      Telemetry telemetry,
      AgentFleet fleet,
      InstantSource clock,
      Deque<AutoCloseable> parts) {
    BrokerConnection connection =
        new BrokerConnection(
            address,
            user,
            password,
            new Topics(site.name()),
            telemetry.board(),
            new EnglishStates(),
            fleet.snapshots(),
            clock);
    fleet.addWarning(connection::trouble);
    parts.push(connection);
    connection.start();
  }

  /** As the API tells it. */
  private static final class EnglishStates implements StateWriter {
    private final ObjectWriter json = Json.writer(Locale.ENGLISH);

    @Override
    public byte[] robot(RobotView robot) {
      return json.writeValueAsBytes(RobotJson.of(robot));
    }

    @Override
    public byte[] task(TaskView task) {
      return json.writeValueAsBytes(TaskJson.of(task));
    }
  }

  /** Robots by the passwords that were made for them, programs by their tokens. */
  private record Users(Site site, Telemetry telemetry, SessionStore sessions)
      implements EmbeddedBroker.SiteUsers {
    @Override
    public boolean isRobot(String name, String password) {
      return telemetry.isPassword(name, password);
    }

    @Override
    public OptionalLong reader(String token) {
      return Secret.site(token) == site.id()
          ? sessions
              .find(Session.Carrier.BEARER, token)
              .filter(login -> login.session().kind() == Session.Kind.TOKEN)
              .filter(login -> !login.account().disabled())
              .filter(login -> login.session().scopes().contains(Scope.READ))
              .map(login -> OptionalLong.of(login.account().id()))
              .orElse(OptionalLong.empty())
          : OptionalLong.empty();
    }
  }

  @Override
  public void close() {
    if (broker != null) {
      broker.close();
    }
  }
}
