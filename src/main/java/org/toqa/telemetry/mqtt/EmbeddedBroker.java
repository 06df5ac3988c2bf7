package org.toqa.telemetry.mqtt;

import io.moquette.BrokerConstants;
import io.moquette.broker.ClientDescriptor;
import io.moquette.broker.ISslContextCreator;
import io.moquette.broker.Server;
import io.moquette.broker.config.IConfig;
import io.moquette.broker.config.MemoryConfig;
import io.moquette.broker.security.IAuthorizatorPolicy;
import io.moquette.broker.subscriptions.Topic;
import io.moquette.interception.AbstractInterceptHandler;
import io.moquette.interception.messages.InterceptConnectionLostMessage;
import io.moquette.interception.messages.InterceptDisconnectMessage;
import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslContextBuilder;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Properties;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.Secret;
import org.toqa.fleet.PeriodicWork;
import org.toqa.persistence.StoreException;

/**
 * An MQTT broker in this process (Moquette), for all sites of the server; {@code docs/telemetry.md}
 * says who may do what. It keeps nothing on disk: states are published anew after a start.
 *
 * <ol>
 *   <li>{@link #start} takes the port.
 *   <li>{@link #add} lets the users of a site in, until {@link #remove}.
 *   <li>{@link #close} ends all connections.
 * </ol>
 *
 * Any thread may call it.
 */
public final class EmbeddedBroker implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(EmbeddedBroker.class);

  /** Bytes: of the server's own messages; robots' are far shorter. */
  static final int MAX_BYTES = 65_536;

  private static final int CONNECTIONS_PER_USER = 20;

  /** Messages that wait for each of the broker's threads. */
  private static final int QUEUE = 16_384;

  private static final int LONGEST_CLIENT_ID = 128;

  /** So many passwords are asked of the store at a time; connections share few threads. */
  private static final int CHECKS_AT_ONCE = 2;

  /** So long somebody waits for those before him. */
  private static final Duration CHECK_LIMIT = Duration.ofSeconds(1);

  private static final Duration CHECK_PERIOD = Duration.ofSeconds(4);

  /** From its login until a client is connected, at most. */
  private static final long CONNECT_NANOS = Duration.ofSeconds(30).toNanos();

  private final Server broker = new Server();
  private final Map<String, SiteUsers> sites = new ConcurrentHashMap<>();
  private final Map<String, Login> connected = new ConcurrentHashMap<>();
  private final Semaphore checks = new Semaphore(CHECKS_AT_ONCE);
  private final String serverPassword = Secret.random();
  private final BrokerAddress address;
  private final PeriodicWork recheck;

  /** Who may come in of a site. Both may wait for the store, and fail as it does. */
  public interface SiteUsers {
    boolean isRobot(String name, String password);

    /**
     * The account whose token of that site lets read.
     *
     * @return its id; empty: none
     */
    OptionalLong reader(String token);
  }

  /**
   * @param holder whose connections count together: a reader may call himself what he likes
   * @param nanos when, on a monotonic clock
   */
  private record Login(String user, String password, String holder, long nanos) {}

  private EmbeddedBroker(BrokerSettings.Embedded settings, BrokerDoor door) throws IOException {
    InetAddress host = settings.address();
    SslContext tls = settings.tls() == null ? null : tlsContext(settings.tls());
    int port = freePort(host, settings.port());
    Thread starter = Thread.currentThread();
    ClassLoader before = starter.getContextClassLoader();
    starter.setContextClassLoader(EmbeddedBroker.class.getClassLoader()); // finds the guard
    try {
      BrokerGuardExtension.start(
          door,
          () ->
              broker.startServer(
                  new MemoryConfig(properties(host, port, tls != null)),
                  List.of(new Leavers()),
                  contexts(tls),
                  this::isLetIn,
                  new Rights()));
    } catch (IOException | RuntimeException e) {
      throw new IOException(portMessage(host, port, e), e);
    } finally {
      starter.setContextClassLoader(before);
    }
    String reached = host.isAnyLocalAddress() ? "127.0.0.1" : host.getHostAddress();
    address =
        settings.tls() == null
            ? BrokerAddress.plain(reached, port)
            : BrokerAddress.tls(reached, port, settings.tls().certificate(), true);
    recheck = new PeriodicWork("mqtt-users", CHECK_PERIOD, () -> recheck(System.nanoTime()));
  }

  /**
   * @param door by which its connections come
   * @throws IOException the port or the certificate cannot be had; the message says what to do
   */
  public static EmbeddedBroker start(BrokerSettings.Embedded settings, BrokerDoor door)
      throws IOException {
    EmbeddedBroker started = new EmbeddedBroker(settings, door);
    log.info("The MQTT broker listens at {}.", started.address.shown());
    return started;
  }

  /** The broker only logs that a port is taken, and takes none of its own choice on TLS. */
  private static int freePort(InetAddress host, int wanted) throws IOException {
    try (ServerSocket probe = new ServerSocket()) {
      probe.setReuseAddress(true);
      probe.bind(new InetSocketAddress(host, wanted));
      return probe.getLocalPort();
    } catch (IOException e) {
      throw new IOException(portMessage(host, wanted, e), e);
    }
  }

  private static String portMessage(InetAddress host, int port, Exception why) {
    return "Port %d on %s cannot be had for MQTT (%s); another program may use it: choose another one by mqtt.port."
        .formatted(port, host.getHostAddress(), why.getMessage());
  }

  private static SslContext tlsContext(BrokerSettings.PemFiles files) throws IOException {
    try {
      return SslContextBuilder.forServer(files.certificate().toFile(), files.key().toFile())
          .protocols("TLSv1.3", "TLSv1.2")
          .build();
    } catch (IOException | IllegalArgumentException e) {
      throw new IOException(
          "mqtt.certificate \"%s\" and mqtt.key \"%s\" cannot be used (%s): give a certificate and its own key without a password, both as PEM, the key as PKCS #8."
              .formatted(files.certificate(), files.key(), e.getMessage()),
          e);
    }
  }

  private static ISslContextCreator contexts(@Nullable SslContext tls) {
    return new ISslContextCreator() {
      @Override
      @SuppressWarnings("NullAway") // without TLS nobody asks for it
      public SslContext initSSLContext() {
        return tls;
      }
    };
  }

  private static Properties properties(InetAddress host, int port, boolean isTls) {
    Properties properties = new Properties();
    properties.setProperty(IConfig.HOST_PROPERTY_NAME, host.getHostAddress());
    String disabled = BrokerConstants.DISABLED_PORT_BIND;
    properties.setProperty(IConfig.PORT_PROPERTY_NAME, isTls ? disabled : String.valueOf(port));
    if (isTls) {
      properties.setProperty(IConfig.SSL_PORT_PROPERTY_NAME, String.valueOf(port));
      properties.setProperty(IConfig.JKS_PATH_PROPERTY_NAME, "none"); // the context is ours
    }
    properties.setProperty(IConfig.WEB_SOCKET_PORT_PROPERTY_NAME, disabled);
    properties.setProperty(IConfig.ALLOW_ANONYMOUS_PROPERTY_NAME, "false");
    properties.setProperty(BrokerConstants.ALLOW_ZERO_BYTE_CLIENT_ID_PROPERTY_NAME, "true");
    properties.setProperty(IConfig.PERSISTENCE_ENABLED_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.ENABLE_TELEMETRY_NAME, "false");
    properties.setProperty(IConfig.SESSION_QUEUE_SIZE, String.valueOf(QUEUE));
    properties.setProperty(IConfig.NETTY_MAX_BYTES_PROPERTY_NAME, String.valueOf(MAX_BYTES));
    properties.setProperty(IConfig.BUFFER_FLUSH_MS_PROPERTY_NAME, "0");
    return properties;
  }

  /** Where this server's own connections find it. */
  public BrokerAddress address() {
    return address;
  }

  /** The name of this server's own connection for a site. */
  public String serverUser(String site) {
    return site + "/server";
  }

  /** Its password, which is another one after each start. */
  public String serverPassword() {
    return serverPassword;
  }

  public void add(String site, SiteUsers users) {
    sites.put(site, users);
  }

  /** Nobody of that site is let in any more, and who is in is sent away. */
  public void remove(String site) {
    sites.remove(site);
    endRevoked();
  }

  /** Called by the connections' threads. */
  private boolean isLetIn(
      @Nullable String clientId, @Nullable String user, byte @Nullable [] password) {
    if (clientId == null
        || user == null
        || password == null
        || clientId.length() > LONGEST_CLIENT_ID) {
      return false;
    }
    String given = new String(password, StandardCharsets.UTF_8);
    Optional<String> holder =
        isClientIdFree(clientId, user) ? holderAfterAll(user, given) : Optional.empty();
    if (holder.filter(who -> connectionsOf(who) < CONNECTIONS_PER_USER).isEmpty()) {
      return false;
    }
    connected.put(clientId, new Login(user, given, holder.get(), System.nanoTime()));
    return true;
  }

  private long connectionsOf(String holder) {
    return connected.values().stream().filter(login -> login.holder().equals(holder)).count();
  }

  /** After others that are asked for; empty also while the store does not answer. */
  private Optional<String> holderAfterAll(String user, String password) {
    try {
      if (!checks.tryAcquire(CHECK_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        return Optional.empty();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
    try {
      return holder(user, password);
    } catch (StoreException e) {
      return Optional.empty();
    } finally {
      checks.release();
    }
  }

  /** A connection is taken over by its client ID: by nobody but its user. */
  private boolean isClientIdFree(String clientId, String user) {
    Login now = connected.get(clientId);
    return now == null || now.user().equals(user);
  }

  /** Whose that password is; empty: not of a user who is called so. */
  private Optional<String> holder(String name, String password) {
    Optional<MqttUser> user = MqttUser.of(name);
    SiteUsers users = user.isEmpty() ? null : sites.get(user.get().topics().site());
    if (users == null) {
      return Optional.empty();
    }
    return switch (user.get()) {
      case MqttUser.Server _ ->
          password.equals(serverPassword) ? Optional.of(name) : Optional.empty();
      case MqttUser.Robot robot ->
          users.isRobot(robot.name(), password) ? Optional.of(name) : Optional.empty();
      case MqttUser.Reader reader -> {
        OptionalLong account =
            Secret.isWellFormed(password) ? users.reader(password) : OptionalLong.empty();
        yield account.isPresent()
            ? Optional.of(reader.topics().site() + "/reader/" + account.getAsLong())
            : Optional.empty();
      }
    };
  }

  /** From time to time. */
  void recheck(long nanos) {
    forgetDropped(nanos);
    endRevoked();
  }

  /** The broker says nothing of who has left before it had a session for him. */
  private void forgetDropped(long nanos) {
    Set<String> present = present();
    connected.forEach(
        (clientId, login) -> {
          if (nanos - login.nanos() > CONNECT_NANOS && !present.contains(clientId)) {
            connected.remove(clientId, login); // unless it has come back meanwhile
          }
        });
  }

  /** The client IDs of those that have a session and a connection. */
  Set<String> present() {
    return broker.listConnectedClients().stream()
        .map(ClientDescriptor::getClientID)
        .collect(Collectors.toSet());
  }

  private void endRevoked() {
    connected.forEach(
        (clientId, login) -> {
          try {
            if (holder(login.user(), login.password()).isEmpty()) {
              connected.remove(clientId, login);
              broker.disconnectClient(clientId);
            }
          } catch (StoreException e) {
            log.debug("Whether {} may stay is not known now.", login.user(), e);
          }
        });
  }

  /** What a user may do follows from his name. */
  private static final class Rights implements IAuthorizatorPolicy {
    @Override
    public boolean canWrite(Topic topic, String user, String clientId) {
      return MqttUser.of(user).filter(known -> known.mayWrite(topic.toString())).isPresent();
    }

    @Override
    public boolean canRead(Topic topic, String user, String clientId) {
      return MqttUser.of(user).filter(known -> known.mayRead(topic.toString())).isPresent();
    }
  }

  /** Hears who has left. */
  private final class Leavers extends AbstractInterceptHandler {
    @Override
    public String getID() {
      return "leavers";
    }

    @Override
    public void onDisconnect(InterceptDisconnectMessage message) {
      forget(message.getClientID());
    }

    @Override
    public void onConnectionLost(InterceptConnectionLostMessage message) {
      forget(message.getClientID());
    }

    @Override
    public void onSessionLoopError(Throwable error) {
      log.error("The MQTT broker has a fault.", error);
    }

    /** Unless it has come back meanwhile. */
    private void forget(String clientId) {
      boolean isBack =
          broker.listConnectedClients().stream()
              .anyMatch(client -> client.getClientID().equals(clientId));
      if (!isBack) {
        connected.remove(clientId);
      }
    }
  }

  @Override
  public void close() {
    recheck.close();
    broker.stopServer();
  }
}
