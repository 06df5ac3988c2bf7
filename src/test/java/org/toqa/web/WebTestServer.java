package org.toqa.web;

import com.github.benmanes.caffeine.cache.Ticker;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.apache.catalina.LifecycleException;
import org.apache.catalina.LifecycleState;
import org.apache.catalina.connector.Connector;
import org.apache.catalina.core.StandardContext;
import org.apache.catalina.startup.Tomcat;
import org.apache.catalina.valves.RemoteIpValve;
import org.apache.tomcat.util.scan.StandardJarScanFilter;
import org.apache.tomcat.util.scan.StandardJarScanner;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.SqlLogger;
import org.jdbi.v3.core.statement.StatementContext;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.FirstStartCode;
import org.toqa.accounts.LoginThrottle;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.Role;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
import org.toqa.app.lab.ExperimentProcess;
import org.toqa.camera.Cameras;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.exploration.Explorer;
import org.toqa.fleet.history.SeenPlaces;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.lab.record.Laboratory;
import org.toqa.network.DhcpSettings;
import org.toqa.network.Network;
import org.toqa.network.Subnet;
import org.toqa.notices.Notices;
import org.toqa.notices.WebhookAddresses;
import org.toqa.notices.WebhookPoster;
import org.toqa.store.Database;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.JdbiCameraStore;
import org.toqa.store.JdbiDeviceStore;
import org.toqa.store.JdbiEventArchive;
import org.toqa.store.JdbiExplorationStore;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiLabRunStore;
import org.toqa.store.JdbiNoticeStore;
import org.toqa.store.JdbiPasswordResetStore;
import org.toqa.store.JdbiSceneStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.JdbiSessionStore;
import org.toqa.store.JdbiStatisticsArchive;
import org.toqa.store.JdbiSupervisionStore;
import org.toqa.store.JdbiTaskTemplateStore;
import org.toqa.store.JdbiTelemetryStore;
import org.toqa.store.JdbiTrackStore;
import org.toqa.store.JdbiUtilisationStore;
import org.toqa.store.LastKnownUsers;
import org.toqa.store.MemoryDatabase;
import org.toqa.telemetry.Telemetry;
import org.toqa.testbed.CheapPassword;
import org.toqa.testbed.RealMySql;

/** The shipped web application in an embedded Tomcat, over a fleet in memory. */
public final class WebTestServer implements AutoCloseable {
  private static final Site SITE = new Site(Site.FIRST_ID, "main");
  public static final String CLERK = "Clara";
  public static final String MANAGER = "Max";
  public static final String PASSWORD = "a long enough password";

  private static final PasswordHasher PASSWORDS = CheapPassword.hasher();

  /** Tables of what a fleet has done. */
  private static final List<String> WORK =
      List.of(
          "notices",
          "notice_preferences",
          "notice_choices",
          "webhooks",
          "robot_use",
          "tracks",
          "load_places",
          "planned_paths",
          "battery_levels",
          "events",
          "drives",
          "lab_runs",
          "network_devices",
          "cameras",
          "supervisions",
          "explorations",
          "schedules",
          "task_templates",
          "tasks",
          "robots");

  /** Live streams. */
  public static final int STREAMS_PER_USER = 20;

  public static final int STREAMS_PER_ADDRESS = 30;

  /** Of each kind. */
  private static final int SESSIONS_PER_USER = 200;

  private static final RequestLimit NO_LIMIT = new RequestLimit(0, Ticker.systemTicker());

  public static final String PASSWORD_HASH = CheapPassword.hash(PASSWORD);

  /** With the views as servlets, as the build has compiled them. */
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();

  private final AtomicLong sessionQueries = new AtomicLong();
  private final TestFleet fleet;
  private final SeenPlaces seenPlaces = new SeenPlaces(Map.of());
  private final TestMailbox mailbox = new TestMailbox();
  private final FirstStartCode firstStartCode = FirstStartCode.random();
  private final AccountStore accounts;
  private final Telemetry telemetry;
  private final Notices notices;
  private final Supervisor supervisor;
  private final JdbiFleetStore store;
  private final JdbiTrackStore tracks;
  private final JdbiSceneStore scenes;
  private final JdbiUtilisationStore uses;
  private final Laboratory laboratory;
  private final Explorer explorer;
  private volatile double explorationSpeed = Double.POSITIVE_INFINITY;
  private final Network network;
  private final Cameras cameras;
  private final Database database;
  private final Tomcat tomcat = new Tomcat();
  private final Path baseDir;

  /** With a clerk and a manager. */
  public static WebTestServer start() throws IOException, LifecycleException {
    return start(0);
  }

  /**
   * The same; on the MySQL of {@code -Dtoqa.mysql.url} where {@code -Dtoqa.browser.mysql=true}
   * wants it so, which takes twice as long.
   */
  public static WebTestServer startForBrowser()
      throws IOException, LifecycleException, SQLException {
    return Boolean.getBoolean("toqa.browser.mysql") ? startOnMySql() : start();
  }

  /** The same, on the MySQL of {@code -Dtoqa.mysql.url}. */
  public static WebTestServer startOnMySql() throws IOException, LifecycleException, SQLException {
    return withUsers(
        new WebTestServer(0, Database.open(RealMySql.newDatabase(), "", ""), NO_LIMIT));
  }

  /**
   * With a clerk and a manager.
   *
   * @param port 0 for a free one
   */
  public static WebTestServer start(int port) throws IOException, LifecycleException {
    return withUsers(startEmpty(port));
  }

  /** With a clerk and a manager, who are told to wait when they ask too fast. */
  public static WebTestServer start(RequestLimit limit) throws IOException, LifecycleException {
    return withUsers(new WebTestServer(0, inMemory(), limit));
  }

  private static WebTestServer withUsers(WebTestServer server) {
    server.addUser(CLERK, null, Role.CLERK);
    server.addUser(MANAGER, null, Role.MANAGER);
    return server;
  }

  /** Somebody with the password of all. */
  public void addUser(String name, @Nullable String email, Role role) {
    if (accounts.add(name, email, PASSWORD_HASH, role, EventRecord.SYSTEM).isEmpty()) {
      throw new IllegalStateException(name + " is there already");
    }
  }

  /** For the next test of a class: nothing has happened yet; users and their sessions stay. */
  public void forgetWork() {
    fleet.forgetAll();
    database
        .jdbi()
        .useHandle(handle -> WORK.forEach(table -> handle.execute("delete from " + table)));
  }

  /** As if all sessions had begun, and been used, so much earlier. */
  public void letSessionsAge(Duration age) {
    String earlier = "timestampadd(second, -" + age.toSeconds() + ", ";
    database
        .jdbi()
        .useHandle(
            handle ->
                handle.execute(
                    "update sessions set created_at = "
                        + earlier
                        + "created_at), seen_at = "
                        + earlier
                        + "seen_at), expires_at = "
                        + earlier
                        + "expires_at)"));
  }

  /** Nobody is logged in any more. */
  public void endSessions() {
    database.jdbi().useHandle(handle -> handle.execute("delete from sessions"));
  }

  /**
   * Without any user.
   *
   * @param port 0 for a free one
   */
  public static WebTestServer startEmpty(int port) throws IOException, LifecycleException {
    return new WebTestServer(port, inMemory(), NO_LIMIT);
  }

  private static Database inMemory() {
    return MemoryDatabase.open("web-" + System.nanoTime());
  }

  private WebTestServer(int port, Database database, RequestLimit limit)
      throws IOException, LifecycleException {
    this.database = database;
    Jdbi jdbi = database.jdbi();
    JdbiScheduleStore schedules = new JdbiScheduleStore(jdbi);
    LastKnownUsers lastKnown = new LastKnownUsers();
    accounts = new JdbiAccountStore(jdbi, InstantSource.system(), lastKnown);
    fleet =
        new TestFleet(
            schedules, name -> accounts.accountByName(name).map(Account::id).orElse(null));
    database.sessions().setSqlLogger(new QueryCounter());
    SessionStore sessions =
        new JdbiSessionStore(
            database.sessions(),
            InstantSource.system(),
            Duration.ofDays(7),
            SESSIONS_PER_USER,
            SITE,
            lastKnown);
    PasswordLinks links =
        new PasswordLinks(
            accounts,
            new JdbiPasswordResetStore(jdbi, InstantSource.system(), SITE, lastKnown),
            mailbox,
            InstantSource.system());
    tracks = new JdbiTrackStore(jdbi);
    scenes = new JdbiSceneStore(jdbi);
    uses = new JdbiUtilisationStore(jdbi);
    telemetry =
        new Telemetry(
            SITE.name(),
            new Telemetry.BrokerPlace("mqtt://127.0.0.1:1883", true),
            name ->
                fleet.snapshots().latest().robots().stream().anyMatch(r -> r.name().equals(name)),
            (robot, seen) -> {},
            new JdbiTelemetryStore(jdbi, InstantSource.system()),
            InstantSource.system());
    laboratory =
        new Laboratory(
            new JdbiLabRunStore(jdbi),
            new ExperimentProcess(),
            new Semaphore(1),
            InstantSource.system());
    explorer =
        new Explorer(
            new JdbiExplorationStore(jdbi), fleet, InstantSource.system(), () -> explorationSpeed);
    baseDir = Files.createTempDirectory("toqa-web-test");
    network =
        new Network(
            new JdbiDeviceStore(jdbi, InstantSource.system()),
            new DhcpSettings(
                Subnet.parse("10.0.7.0/24").orElseThrow(), reservations(), leases(), null),
            InstantSource.system());
    cameras = new Cameras(new JdbiCameraStore(jdbi, InstantSource.system()));
    WebhookAddresses webhookAddresses =
        new WebhookAddresses(List.of(WebhookAddresses.Network.parse("127.0.0.1").orElseThrow()));
    notices =
        new Notices(
            new JdbiNoticeStore(jdbi),
            true,
            webhookAddresses,
            new WebhookPoster(SITE.name(), webhookAddresses, InstantSource.system()),
            InstantSource.system());
    supervisor =
        new Supervisor(
            new JdbiSupervisionStore(jdbi),
            fleet,
            fleet,
            InstantSource.system(),
            InstantSource.system());
    Services services =
        new Services(
            SITE,
            fleet,
            fleet,
            fleet,
            fleet,
            new JdbiEventArchive(jdbi),
            tracks,
            scenes,
            schedules,
            new JdbiTaskTemplateStore(jdbi, InstantSource.system()),
            supervisor,
            explorer,
            new JdbiStatisticsArchive(jdbi),
            seenPlaces,
            telemetry,
            laboratory,
            network,
            cameras,
            notices,
            accounts,
            sessions,
            links,
            PASSWORDS,
            metrics(fleet.snapshots()),
            limit,
            ConcurrencyLimits.of(1000, STREAMS_PER_USER, STREAMS_PER_ADDRESS, 8192),
            InstantSource.system(),
            new Authenticator(accounts, PASSWORDS, new LoginThrottle(InstantSource.system()), SITE),
            new IdempotentSubmitter(fleet, fleet, fleet),
            new AllowedHosts(Set.of("toqa.example.org")),
            firstStartCode);
    store = new JdbiFleetStore(jdbi);
    startTomcat(port, services);
  }

  /** What a DHCP server would read. */
  public Path reservations() {
    return baseDir.resolve("reservations");
  }

  /** What a DHCP server would write. */
  public Path leases() {
    return baseDir.resolve("leases");
  }

  /** What robots saw; the fleet of this server sees nothing by itself. */
  public SeenPlaces seenPlaces() {
    return seenPlaces;
  }

  /** What robots publish; no broker hears them here. */
  public Telemetry telemetry() {
    return telemetry;
  }

  /** Nobody watches the fleet for them here. */
  public Notices notices() {
    return notices;
  }

  private static Metrics metrics(SnapshotFeed snapshots) {
    return new Metrics(snapshots, true);
  }

  private void startTomcat(int port, Services services) throws LifecycleException {
    tomcat.setBaseDir(baseDir.toString());
    Connector connector = new Connector();
    connector.setPort(port);
    connector.setProperty("address", "127.0.0.1");
    connector.setProperty("useVirtualThreads", "true");
    tomcat.setConnector(connector);
    StandardContext context = (StandardContext) tomcat.addWebapp("", WEBAPP.toString());
    context.setParentClassLoader(WebTestServer.class.getClassLoader());
    StandardJarScanFilter filter = new StandardJarScanFilter();
    filter.setDefaultTldScan(false);
    filter.setDefaultPluggabilityScan(false);
    filter.setTldScan("jakarta.servlet.jsp.jstl-*.jar");
    ((StandardJarScanner) context.getJarScanner()).setJarScanFilter(filter);
    context.addServletContainerInitializer(
        (classes, servletContext) ->
            servletContext.setAttribute(Sites.ATTRIBUTE, new OneSite(services)),
        null);
    tomcat.getEngine().getPipeline().addValve(new RemoteIpValve()); // proxies on this machine
    tomcat.start();
  }

  /** How long those who connect from now on may neither send nor take anything. */
  public void setConnectionTimeout(Duration limit) {
    tomcat.getConnector().setProperty("connectionTimeout", String.valueOf(limit.toMillis()));
  }

  /** What the history is read from. */
  public JdbiFleetStore store() {
    return store;
  }

  /** What the server would have printed. */
  public String firstStartCode() {
    return firstStartCode.text();
  }

  /** How often the database was asked whose a request is. */
  public long sessionQueries() {
    return sessionQueries.get();
  }

  private final class QueryCounter implements SqlLogger {
    @Override
    public void logBeforeExecution(StatementContext context) {
      sessionQueries.incrementAndGet();
    }
  }

  public TestMailbox mailbox() {
    return mailbox;
  }

  public JdbiTrackStore tracks() {
    return tracks;
  }

  public JdbiSceneStore scenes() {
    return scenes;
  }

  JdbiUtilisationStore uses() {
    return uses;
  }

  /** It looks when it is told to. */
  public Supervisor supervisor() {
    return supervisor;
  }

  public TestFleet fleet() {
    return fleet;
  }

  public AccountStore accounts() {
    return accounts;
  }

  /** The root, with a slash at its end. */
  public URI root() {
    return URI.create("http://127.0.0.1:%d/".formatted(tomcat.getConnector().getLocalPort()));
  }

  @Override
  public void close() throws LifecycleException, IOException {
    if (tomcat.getServer().getState() == LifecycleState.DESTROYED) {
      return;
    }
    tomcat.stop();
    tomcat.destroy();
    explorer.close();
    laboratory.close();
    network.close();
    cameras.close();
    database.close();
    delete(baseDir);
  }

  /**
   * How fast floors are explored from the next step on.
   *
   * @param speed simulated seconds a second; infinite, as at first: as fast as it can
   */
  public void setExplorationSpeed(double speed) {
    explorationSpeed = speed;
  }

  /** Its experiments run as those of a server do. */
  public Laboratory laboratory() {
    return laboratory;
  }

  private static void delete(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
