package org.toqa.app.server;

import java.io.IOException;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.Role;
import org.toqa.accounts.Site;
import org.toqa.accounts.SiteStore;
import org.toqa.app.config.Configuration;
import org.toqa.fleet.Answer;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.web.ServerSetting;
import org.toqa.web.Services;
import org.toqa.web.SiteSummary;
import org.toqa.web.Sites;
import org.toqa.wording.Phrase;

/**
 * The sites of this server, each with a database, a folder and a {@link FleetServer} of its own:
 * what one of them asks reaches nothing of another. The first one is the server's, as configured;
 * without it there is none. Another one that cannot start, or fails, is shown so, and disturbs no
 * other.
 */
public final class SiteServers implements Sites, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(SiteServers.class);

  private final Configuration configuration;
  private final ServerParts shared;
  private final FleetServer first;
  private final SiteStore store;

  /** By id: those beside the first one. */
  private final Map<Long, Entry> others = new ConcurrentHashMap<>();

  /** Makes and ends sites, one after the other. */
  private final ExecutorService changes =
      Executors.newSingleThreadExecutor(Thread.ofVirtual().name("sites").factory());

  /**
   * A site beside the first one.
   *
   * @param server null: it cannot be used
   * @param failure why not, in English; null: it can
   */
  private record Entry(Site site, @Nullable FleetServer server, @Nullable String failure) {}

  private SiteServers(Configuration configuration, ServerParts shared, FleetServer first) {
    this.configuration = configuration;
    this.shared = shared;
    this.first = first;
    this.store = first.sites();
  }

  /**
   * @throws IOException the first site's map or database cannot be used, or a robot cannot be
   *     simulated; the message says what to do
   */
  static SiteServers start(Configuration configuration) throws IOException {
    return start(configuration, new PasswordHasher());
  }

  static SiteServers start(Configuration configuration, PasswordHasher passwords)
      throws IOException {
    ServerParts shared = ServerParts.of(configuration, passwords, InstantSource.system());
    Site site = new Site(Site.FIRST_ID, "main");
    FleetServer first;
    try {
      first = FleetServer.start(site, configuration, shared);
    } catch (IOException | RuntimeException e) {
      shared.telemetry().close();
      throw e;
    }
    SiteServers sites = new SiteServers(configuration, shared, first);
    try {
      sites.startOthers();
      return sites;
    } catch (RuntimeException e) {
      sites.close();
      throw e;
    }
  }

  private void startOthers() {
    store.discardReserved();
    for (Site site : store.sites()) {
      if (!site.isFirst()) {
        try {
          begin(site, startServer(site));
        } catch (IOException | RuntimeException e) {
          log.error("The site {} cannot be used.", site.name(), e);
          others.put(site.id(), new Entry(site, null, String.valueOf(e.getMessage())));
        }
      }
    }
  }

  private FleetServer startServer(Site site) throws IOException {
    Configuration.DatabaseSettings database = configuration.database();
    Path data = configuration.data().resolve("sites").resolve(String.valueOf(site.id()));
    return FleetServer.start(
        site,
        configuration.ofSite(data, database.at(Database.siteUrl(database.url(), site))),
        shared);
  }

  private void begin(Site site, FleetServer server) {
    others.put(site.id(), new Entry(site, server, null));
    var _ =
        server
            .whenFailed()
            .thenAccept(
                reason -> {
                  log.error("The site {} cannot go on: {}", site.name(), reason);
                  others.computeIfPresent(site.id(), (_, _) -> new Entry(site, null, reason));
                  changes.execute(server::close);
                });
  }

  @Override
  public List<ServerSetting> settings() {
    return configuration.settings().stream()
        .map(one -> new ServerSetting(one.key(), one.value(), one.origin(), one.allowed()))
        .toList();
  }

  @Override
  public String logLevel() {
    return Logging.level();
  }

  @Override
  public void changeLogLevel(String level, String by) {
    Logging.changeLevel(level);
    log.warn("{} has set the level of the log to {}.", by, level);
  }

  /** That of the first site. */
  FleetServer firstServer() {
    return first;
  }

  @Override
  public Services first() {
    return first.services();
  }

  @Override
  public Optional<Services> find(long id) {
    return id == Site.FIRST_ID ? Optional.of(first()) : services(others.get(id));
  }

  @Override
  public Optional<Services> find(String name) {
    String key = Site.key(name);
    return running().stream().filter(s -> Site.key(s.site().name()).equals(key)).findFirst();
  }

  private static Optional<Services> services(@Nullable Entry entry) {
    return Optional.ofNullable(entry).map(Entry::server).map(FleetServer::services);
  }

  @Override
  public List<Services> running() {
    return Stream.concat(Stream.of(first()), entries().flatMap(entry -> services(entry).stream()))
        .toList();
  }

  private Stream<Entry> entries() {
    return others.values().stream().sorted(Comparator.comparing(entry -> entry.site().id()));
  }

  @Override
  public List<SiteSummary> all() {
    return Stream.concat(Stream.of(SiteSummary.of(first())), entries().map(SiteServers::summary))
        .toList();
  }

  private static SiteSummary summary(Entry entry) {
    Site site = entry.site();
    Optional<Services> services = services(entry);
    if (services.isEmpty()) {
      return SiteSummary.failed(site, String.valueOf(entry.failure()));
    }
    try {
      return SiteSummary.of(services.get());
    } catch (StoreException e) {
      return SiteSummary.failed(site, String.valueOf(e.getMessage()));
    }
  }

  @Override
  public CompletionStage<Answer<SiteSummary>> add(
      String name, String manager, String passwordHash, String by) {
    return CompletableFuture.supplyAsync(() -> addNow(name, manager, passwordHash, by), changes);
  }

  private Answer<SiteSummary> addNow(String name, String manager, String passwordHash, String by) {
    Optional<Site> reserved = store.reserve(name);
    if (reserved.isEmpty()) {
      return new Answer.Rejected<>("name", Phrase.SITE_EXISTS.with(name));
    }
    Site site = reserved.get();
    FleetServer server;
    try {
      server = startServer(site);
    } catch (IOException | RuntimeException e) {
      log.error("The site {} cannot be made.", name, e);
      store.discardReserved();
      return new Answer.Conflict<>(
          Phrase.SITE_CANNOT_START.with(name, String.valueOf(e.getMessage())), null);
    }
    try {
      server.services().accounts().add(manager, passwordHash, Role.MANAGER, by);
      store.complete(site, by);
    } catch (RuntimeException e) {
      server.close();
      discardReserved(e);
      throw e;
    }
    begin(site, server);
    return new Answer.Accepted<>(SiteSummary.of(server.services()));
  }

  /** Its name can be taken again, as far as the store answers. */
  private void discardReserved(RuntimeException failure) {
    try {
      store.discardReserved();
    } catch (StoreException e) {
      failure.addSuppressed(e);
    }
  }

  @Override
  public CompletionStage<Answer<String>> remove(String name, String by) {
    return CompletableFuture.supplyAsync(() -> removeNow(name, by), changes);
  }

  private Answer<String> removeNow(String name, String by) {
    String key = Site.key(name);
    if (Site.key(first().site().name()).equals(key)) {
      return new Answer.Conflict<>(Phrase.FIRST_SITE_STAYS.with(), null);
    }
    Optional<Entry> found =
        entries().filter(entry -> Site.key(entry.site().name()).equals(key)).findFirst();
    if (found.isEmpty()) {
      return new Answer.Unknown<>(Phrase.NO_SUCH_SITE.with(name));
    }
    Entry entry = found.get();
    FleetServer server = entry.server();
    if (server != null) {
      SiteSummary now = SiteSummary.of(server.services());
      if (now.openTasks() > 0) {
        return new Answer.Conflict<>(Phrase.SITE_HAS_TASKS.with(now.name(), now.openTasks()), null);
      }
      if (now.robots() > 0) {
        return new Answer.Conflict<>(Phrase.SITE_HAS_ROBOTS.with(now.name(), now.robots()), null);
      }
    }
    store.remove(entry.site(), by);
    others.remove(entry.site().id());
    if (server != null) {
      server.close();
    }
    return new Answer.Accepted<>(entry.site().name());
  }

  @Override
  public void close() {
    changes.close();
    others.values().stream()
        .flatMap(entry -> Stream.ofNullable(entry.server()))
        .forEach(FleetServer::close);
    first.close();
    shared.telemetry().close();
  }
}
