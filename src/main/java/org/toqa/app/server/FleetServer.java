package org.toqa.app.server;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletionStage;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.FirstStartCode;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
import org.toqa.accounts.SiteStore;
import org.toqa.app.config.Configuration;
import org.toqa.app.lab.ExperimentProcess;
import org.toqa.camera.Cameras;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.fleet.exploration.Explorer;
import org.toqa.fleet.history.SceneRecorder;
import org.toqa.fleet.history.SeenPlaces;
import org.toqa.fleet.history.SightingRecorder;
import org.toqa.fleet.history.TrackRecorder;
import org.toqa.fleet.history.UtilisationRecorder;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.fleet.schedule.Scheduler;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.lab.record.Laboratory;
import org.toqa.link.trust.PrivateFolder;
import org.toqa.network.Network;
import org.toqa.notices.NoticeRecorder;
import org.toqa.notices.NoticeStore;
import org.toqa.notices.Notices;
import org.toqa.notices.Outbox;
import org.toqa.notices.WebhookPoster;
import org.toqa.sim.Body;
import org.toqa.sim.Participant;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.DatabaseSize;
import org.toqa.store.HistoryPruner;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.JdbiCameraStore;
import org.toqa.store.JdbiDeviceStore;
import org.toqa.store.JdbiEventArchive;
import org.toqa.store.JdbiExplorationStore;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiFloorStore;
import org.toqa.store.JdbiLabRunStore;
import org.toqa.store.JdbiNoticeStore;
import org.toqa.store.JdbiOrderArchive;
import org.toqa.store.JdbiPasswordResetStore;
import org.toqa.store.JdbiSceneStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.JdbiServerRuns;
import org.toqa.store.JdbiSessionStore;
import org.toqa.store.JdbiSightingStore;
import org.toqa.store.JdbiSiteStore;
import org.toqa.store.JdbiStatisticsArchive;
import org.toqa.store.JdbiSupervisionStore;
import org.toqa.store.JdbiTaskTemplateStore;
import org.toqa.store.JdbiTaskTraces;
import org.toqa.store.JdbiTelemetryStore;
import org.toqa.store.JdbiTrackStore;
import org.toqa.store.JdbiUtilisationStore;
import org.toqa.store.LastKnownUsers;
import org.toqa.telemetry.Telemetry;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.MailSender;
import org.toqa.web.Metrics;
import org.toqa.web.NoticeLetters;
import org.toqa.web.PasswordLinks;
import org.toqa.web.Services;
import org.toqa.web.input.TemplatesOfFloors;
import org.toqa.wording.Phrase;

/**
 * Everything behind the web pages of one site: store, fleet and simulated robots. It has one owner,
 * the server's {@link SiteServers}.
 *
 * <p>Started in order: database, first manager, floors, simulated robots, fleet, time, records.
 * Closed in the reverse order.
 */
public final class FleetServer implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(FleetServer.class);
  private static final Duration FLEET_TICK = Duration.ofMillis(100);

  /** A floor that takes longer does not hold up the others. */
  private static final Duration FIRST_SNAPSHOT_LIMIT = Duration.ofSeconds(5);

  private static final String NONE_SIMULATED = "No robots are simulated.";
  private static final Duration SCHEDULE_PERIOD = Duration.ofSeconds(1);

  private final Configuration configuration;
  private final Database database;
  private final VirtualClock fleetClock;
  private final Services services;

  /** Null: no robots are simulated. */
  private final @Nullable TrueBodies bodies;

  /** Null with them. */
  private final @Nullable SimulatedFleet simulated;

  private final CompletionStage<String> failed;

  /** What is to be closed, the last one first. */
  private final Deque<AutoCloseable> parts;

  private FleetServer(
      Configuration configuration,
      Database database,
      VirtualClock fleetTime,
      Services services,
      @Nullable TrueBodies bodies,
      @Nullable SimulatedFleet simulated,
      CompletionStage<String> failed,
      Deque<AutoCloseable> parts) {
    this.configuration = configuration;
    this.database = database;
    this.fleetClock = fleetTime;
    this.services = services;
    this.bodies = bodies;
    this.simulated = simulated;
    this.failed = failed;
    this.parts = parts;
  }

  /**
   * @throws IOException the map or the database cannot be used, or a robot cannot be simulated; the
   *     message says what to do
   */
  static FleetServer start(Site site, Configuration configuration, ServerParts shared)
      throws IOException {
    Deque<AutoCloseable> parts = new ArrayDeque<>();
    try {
      return start(site, configuration, shared, parts);
    } catch (IOException | RuntimeException e) {
      close(parts);
      throw e;
    }
  }

  private static FleetServer start(
      Site site, Configuration configuration, ServerParts shared, Deque<AutoCloseable> parts)
      throws IOException {
    PrivateFolder.create(configuration.data());
    Database database = openDatabase(configuration.database());
    parts.push(database);
    JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
    InstantSource wallClock = shared.clock();
    HistoryPruner pruner = new HistoryPruner(database.jdbi());
    Optional<Instant> newestEvent = pruner.newestEvent(); // before this start is told of
    JdbiServerRuns runs = new JdbiServerRuns(database.jdbi());
    runs.begin(wallClock.instant());
    parts.push(() -> runs.end(wallClock.instant()));
    LastKnownUsers lastKnown = new LastKnownUsers();
    AccountStore accounts = new JdbiAccountStore(database.sessions(), wallClock, lastKnown);
    addFirstManager(configuration, accounts, shared.passwords());

    JdbiFloorStore floorStore = new JdbiFloorStore(database.jdbi(), configuration.margins());
    List<FloorMap> floors = FirstFloors.of(configuration, floorStore, wallClock.instant());
    VirtualClock clock = new VirtualClock(wallClock.instant(), configuration.simulationSpeed());
    SimulatedFleet simulated =
        configuration.isSimulated()
            ? SimulatedRobots.start(configuration, floors, store, clock)
            : null;
    if (simulated != null) {
      parts.push(simulated);
      shared.simulated().set(simulated);
    }
    JdbiScheduleStore schedules = new JdbiScheduleStore(database.jdbi());
    PublishedRanges ranges = new PublishedRanges(System::nanoTime);
    AgentFleet fleet =
        new AgentFleet(
            floorStore,
            store,
            schedules,
            ServerLinks.open(site, configuration, shared, clock, ranges, parts),
            configuration.allocationPolicy().method(),
            new FleetRules(
                configuration.reassignAfter(),
                configuration.charging(),
                configuration.simulationSpeed(),
                configuration.limits().checksPerUser()),
            wallClock,
            clock.instant());
    parts.push(fleet);
    clock.add(new FleetInWorld(fleet, clock, simulated != null), FLEET_TICK);
    if (simulated != null) {
      fleet.addMapListener(simulated::rebuild);
      fleet.addMoveListener(simulated::carry);
      SimulatedDocks docks = new SimulatedDocks(simulated, fleet);
      clock.add(nanos -> docks.locateStandingRobots(), SimulatedDocks.PERIOD);
    }
    clock.start();
    parts.push(clock);
    awaitFirstSnapshots(fleet);
    fleet.addCheck(
        () -> clock.isSound() ? Optional.empty() : Optional.of(Phrase.CLOCK_STANDS.with()));
    fleet.addCheck(
        () ->
            database.isClosedByItself()
                ? Optional.of(Phrase.DATABASE_CLOSED.with())
                : Optional.empty());
    fleet.addCheck(MemoryWatch.ofThisProcess()::check);
    SessionStore sessions =
        new JdbiSessionStore(
            database.sessions(),
            wallClock,
            configuration.sessionLimit(),
            configuration.limits().sessionsPerUser(),
            site,
            lastKnown);
    MailSender mail =
        configuration.mailServer() == null ? null : new SmtpMail(configuration.mailServer());
    PasswordLinks passwordLinks =
        new PasswordLinks(
            accounts,
            new JdbiPasswordResetStore(database.sessions(), wallClock, site, lastKnown),
            mail,
            new SteadyClock(wallClock.instant(), System::nanoTime));
    Metrics metrics = new Metrics(fleet.snapshots(), site.isFirst());
    parts.push(metrics);
    database.bindMetrics(metrics.registry());
    metrics.bindPassedOver(fleet::passedOver);
    Scheduler scheduler = new Scheduler(schedules, store, fleet, wallClock);
    parts.push(new PeriodicWork("schedules", SCHEDULE_PERIOD, scheduler::runDueSchedules));
    Supervisor supervisor =
        new Supervisor(new JdbiSupervisionStore(database.jdbi()), fleet, store, clock, wallClock);
    supervisor.recover();
    supervisor.begin();
    parts.push(supervisor);
    fleet.addAdviser(supervisor::warning);
    fleet.addFloorListener(supervisor);
    Explorer explorer =
        new Explorer(
            new JdbiExplorationStore(database.jdbi()), fleet, wallClock, () -> Explorer.WATCHED);
    explorer.recover();
    parts.push(explorer);
    fleet.addFloorListener(explorer);
    JdbiTrackStore tracks = new JdbiTrackStore(database.jdbi());
    parts.push(new TrackRecorder(fleet.snapshots(), tracks));
    parts.push(new SceneRecorder(fleet.snapshots(), new JdbiSceneStore(database.jdbi())));
    parts.push(
        new UtilisationRecorder(
            fleet.snapshots(),
            new JdbiUtilisationStore(database.jdbi()),
            wallClock,
            configuration.simulationSpeed()));
    JdbiSightingStore sightings = new JdbiSightingStore(database.jdbi());
    SeenPlaces seenPlaces = new SeenPlaces(sightings.sightings());
    SightingRecorder sightingRecorder =
        new SightingRecorder(fleet, seenPlaces, sightings, wallClock);
    parts.push(sightingRecorder);
    fleet.addFloorListener(sightingRecorder);
    RetentionJob retention =
        new RetentionJob(
            pruner,
            configuration.trackRetention(),
            configuration.historyRetention(),
            newestEvent,
            wallClock,
            System::nanoTime);
    parts.push(retention);
    fleet.addWarning(retention::warning);
    Telemetry telemetry =
        shared
            .telemetry()
            .open(
                site,
                fleet,
                ranges,
                new JdbiTelemetryStore(database.jdbi(), wallClock),
                sessions,
                wallClock,
                parts);
    Laboratory laboratory =
        new Laboratory(
            new JdbiLabRunStore(database.readers()),
            new ExperimentProcess(),
            shared.laboratory(),
            wallClock);
    parts.push(laboratory);
    Network network =
        new Network(
            new JdbiDeviceStore(database.readers(), wallClock), configuration.dhcp(), wallClock);
    parts.push(network);
    network.start();
    Cameras cameras = new Cameras(new JdbiCameraStore(database.readers(), wallClock));
    parts.push(cameras);
    TaskTemplateStore templates = new JdbiTaskTemplateStore(database.readers(), wallClock);
    addObjectors(fleet, templates, cameras);
    Notices notices = startNotices(site, configuration, database, fleet, mail, wallClock, parts);
    Services services =
        new Services(
            site,
            fleet,
            new JdbiFleetStore(database.readers()),
            new JdbiOrderArchive(database.readers()),
            new JdbiTaskTraces(database.readers(), wallClock),
            new JdbiEventArchive(database.readers()),
            new JdbiTrackStore(database.readers()),
            new JdbiSceneStore(database.readers()),
            schedules,
            templates,
            supervisor,
            explorer,
            new JdbiStatisticsArchive(database.readers()),
            seenPlaces,
            telemetry,
            laboratory,
            network,
            cameras,
            notices,
            accounts,
            sessions,
            passwordLinks,
            shared.passwords(),
            metrics,
            shared.requestLimit(),
            shared.concurrency(),
            wallClock,
            new Authenticator(accounts, shared.passwords(), shared.throttle(), site),
            new IdempotentSubmitter(fleet, store, new JdbiOrderArchive(database.jdbi())),
            shared.hosts(),
            firstStartCode(site, accounts));
    TrueBodies bodies =
        simulated == null ? null : new TrueBodies(simulated, fleet.snapshots()::latest);
    CompletionStage<String> failed =
        fleet
            .whenFailed()
            .thenApply(ended -> Phrase.FLEET_ENDED.with().english())
            .applyToEither(
                clock.whenBroken().thenApply(error -> "The clock has ended by " + error),
                Function.identity())
            .applyToEither(
                database
                    .whenClosedByItself()
                    .thenApply(closed -> Phrase.DATABASE_CLOSED.with().english()),
                Function.identity());
    return new FleetServer(
        configuration, database, clock, services, bodies, simulated, failed, parts);
  }

  /** What a person would miss is not removed with its floor. */
  private static void addObjectors(AgentFleet fleet, TaskTemplateStore templates, Cameras cameras) {
    fleet.addFloorListener(new TemplatesOfFloors(templates));
    FloorListener.Objector objector =
        floor ->
            Optional.of(
                    cameras.all().stream().filter(camera -> floor.equals(camera.floor())).count())
                .filter(count -> count > 0)
                .map(count -> Phrase.FLOOR_HAS_CAMERAS.with(floor, count));
    fleet.addFloorListener(objector);
  }

  private static Notices startNotices(
      Site site,
      Configuration configuration,
      Database database,
      Fleet fleet,
      @Nullable MailSender mail,
      InstantSource clock,
      Deque<AutoCloseable> parts) {
    NoticeStore store = new JdbiNoticeStore(database.jdbi());
    WebhookPoster webhooks = new WebhookPoster(site.name(), configuration.webhooks(), clock);
    parts.push(webhooks);
    Notices notices =
        new Notices(
            new JdbiNoticeStore(database.readers()),
            mail != null,
            configuration.webhooks(),
            webhooks,
            clock);
    Outbox outbox =
        new Outbox(store, mail == null ? null : new NoticeLetters(mail), webhooks, clock);
    parts.push(outbox);
    parts.push(
        new NoticeRecorder(
            fleet.snapshots(), new JdbiEventArchive(database.readers()), notices, outbox, clock));
    return notices;
  }

  /** So that nobody who asks right after the start is told that there is nothing. */
  private static void awaitFirstSnapshots(Fleet fleet) throws IOException {
    try {
      for (FloorMap floor : fleet.floors()) {
        Optional<SnapshotFeed> feed = fleet.snapshots(floor.name());
        if (feed.isPresent()) {
          feed.get().awaitNewer(0, FIRST_SNAPSHOT_LIMIT);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("The start was interrupted.", e);
    }
  }

  private static Database openDatabase(Configuration.DatabaseSettings settings) throws IOException {
    try {
      String user = settings.user() == null ? "" : settings.user();
      String password = settings.password() == null ? "" : settings.password();
      return Database.open(settings.url(), user, password);
    } catch (RuntimeException e) {
      if (Database.isInUseElsewhere(e)) {
        throw new IOException(
            "Another server uses the database "
                + withoutCredentials(settings.url())
                + ": stop it, or give this one another folder by --data.",
            e);
      }
      throw new IOException(
          "The database "
              + withoutCredentials(settings.url())
              + " cannot be used: "
              + Database.rootCauseMessage(e),
          e);
    }
  }

  /** They may stand before the host, and among the parameters. */
  private static String withoutCredentials(String url) {
    return url.replaceFirst("[?;].*", "").replaceFirst("//[^/]*@", "//");
  }

  private static void addFirstManager(
      Configuration configuration, AccountStore accounts, PasswordHasher passwords) {
    Configuration.FirstManager manager = configuration.firstManager();
    if (manager != null && !accounts.hasManager()) {
      String password = manager.password();
      accounts.addFirstManager(
          manager.name(), PasswordHasher.isHash(password) ? password : passwords.hash(password));
      log.info("The first manager is {}.", manager.name());
    }
  }

  /** Prints it, as long as there is no manager. */
  private static FirstStartCode firstStartCode(Site site, AccountStore accounts) {
    FirstStartCode code = FirstStartCode.random();
    if (site.isFirst() && !accounts.hasManager()) {
      String sentence = "There is no manager yet: the first page asks for the code " + code.text();
      if (log.isWarnEnabled()) {
        log.warn(sentence);
      } else {
        System.err.println(sentence);
      }
    }
    return code;
  }

  /** Completes, with the reason for a person, when the server cannot go on. */
  CompletionStage<String> whenFailed() {
    return failed;
  }

  /**
   * What its database takes now.
   *
   * @throws java.io.UncheckedIOException its file cannot be read or copied
   */
  public DatabaseSize databaseSize() {
    return database.size();
  }

  /** Bytes of the database's file; empty: it is none of this process. */
  public OptionalLong databaseFileSize() {
    return database.fileSize();
  }

  Configuration configuration() {
    return configuration;
  }

  /** Simulated time, which may pass faster than real time; without simulated robots, real time. */
  public VirtualClock fleetClock() {
    return fleetClock;
  }

  /**
   * From now on the observer is told at every step of the simulated world what is really where on a
   * floor.
   *
   * @param observer called by the world's thread with its time, since its start
   * @return what ends it
   * @throws IllegalStateException no robots are simulated
   */
  public BodyObservation observeBodies(String floor, BiConsumer<Duration, List<Body>> observer) {
    TrueBodies observed = bodies;
    if (observed == null) {
      throw new IllegalStateException(NONE_SIMULATED);
    }
    Participant participant = nanos -> observer.accept(Duration.ofNanos(nanos), observed.on(floor));
    fleetClock.add(participant, VirtualClock.STEP);
    return () -> fleetClock.remove(participant);
  }

  /**
   * Puts somebody or something on a floor of the simulated world, or moves it.
   *
   * @param name of its own
   * @param middle metres, map frame
   * @param radius metres
   * @throws IllegalStateException no robots are simulated
   */
  public void putObstacle(String floor, String name, Vec2 middle, double radius) {
    SimulatedFleet robots = simulated;
    if (robots == null) {
      throw new IllegalStateException(NONE_SIMULATED);
    }
    robots.putObstacle(floor, name, middle, radius);
  }

  /**
   * From now on the observer is told of each pose that a simulated robot reports, before it is
   * sent.
   *
   * @param observer called by the world's threads, with the robot's name; it does not wait
   * @throws IllegalStateException no robots are simulated
   */
  public void observeReports(BiConsumer<String, Pose> observer) {
    SimulatedFleet robots = simulated;
    if (robots == null) {
      throw new IllegalStateException(NONE_SIMULATED);
    }
    robots.observeReports(observer);
  }

  /** Where a simulated robot really is, map frame of the floor where it is; empty: nobody knows. */
  Optional<Pose> truePose(String robot) {
    SimulatedFleet robots = simulated;
    return robots == null ? Optional.empty() : robots.truePose(robot);
  }

  /** Somebody is told where bodies are, until this is closed. */
  public interface BodyObservation extends AutoCloseable {
    @Override
    void close();
  }

  public Fleet fleet() {
    return services.fleet();
  }

  public Supervisor supervisor() {
    return services.supervisor();
  }

  /** Null: MQTT is not configured. */
  public @Nullable Telemetry telemetry() {
    return services.telemetry();
  }

  public Cameras cameras() {
    return services.cameras();
  }

  Services services() {
    return services;
  }

  /** The sites that this one keeps, if it is the first. */
  SiteStore sites() {
    return new JdbiSiteStore(database.jdbi(), services.clock());
  }

  @Override
  public void close() {
    close(parts);
  }

  private static void close(Deque<AutoCloseable> parts) {
    while (!parts.isEmpty()) {
      AutoCloseable part = parts.pop();
      try {
        part.close();
      } catch (Exception e) {
        log.warn("{} did not close cleanly.", part.getClass().getSimpleName(), e);
      }
    }
  }
}
