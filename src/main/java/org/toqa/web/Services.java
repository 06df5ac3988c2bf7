package org.toqa.web;

import jakarta.servlet.ServletRequest;
import java.time.InstantSource;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.FirstStartCode;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.SessionStore;
import org.toqa.accounts.Site;
import org.toqa.camera.Cameras;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.OrderArchive;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.fleet.TaskTraces;
import org.toqa.fleet.exploration.Explorer;
import org.toqa.fleet.history.EventArchive;
import org.toqa.fleet.history.SceneStore;
import org.toqa.fleet.history.SeenPlaces;
import org.toqa.fleet.history.StatisticsArchive;
import org.toqa.fleet.history.TrackStore;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.lab.record.Laboratory;
import org.toqa.network.Network;
import org.toqa.notices.Notices;
import org.toqa.telemetry.Telemetry;

/**
 * What the web application uses of one site.
 *
 * @param site whose fleet and users these are
 * @param telemetry what robots publish by MQTT; null: no broker is configured
 */
public record Services(
    Site site,
    Fleet fleet,
    TaskArchive archive,
    OrderArchive orders,
    TaskTraces traces,
    EventArchive history,
    TrackStore tracks,
    SceneStore scenes,
    ScheduleStore schedules,
    TaskTemplateStore templates,
    Supervisor supervisor,
    Explorer explorer,
    StatisticsArchive statistics,
    SeenPlaces seenPlaces,
    @Nullable Telemetry telemetry,
    Laboratory laboratory,
    Network network,
    Cameras cameras,
    Notices notices,
    AccountStore accounts,
    SessionStore sessions,
    PasswordLinks passwordLinks,
    PasswordHasher passwordHasher,
    Metrics metrics,
    RequestLimit requestLimit,
    ConcurrencyLimits concurrency,
    InstantSource clock,
    Authenticator authenticator,
    IdempotentSubmitter submitter,
    AllowedHosts allowedHosts,
    FirstStartCode firstStartCode) {

  /** The attribute of a request that holds those of the site that it concerns. */
  private static final String ATTRIBUTE = Services.class.getName();

  /** Of the site that the request concerns: its caller's, or the one that he looks at. */
  public static Services of(ServletRequest request) {
    Services chosen = (@Nullable Services) request.getAttribute(ATTRIBUTE);
    return chosen == null ? Sites.of(request.getServletContext()).first() : chosen;
  }

  /** From now on the request concerns this site. */
  public void storeIn(ServletRequest request) {
    request.setAttribute(ATTRIBUTE, this);
  }
}
