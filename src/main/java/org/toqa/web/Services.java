package org.toqa.web;

import jakarta.servlet.ServletContext;
import java.time.InstantSource;
import java.util.Objects;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.FirstStartCode;
import org.toqa.accounts.PasswordHasher;
import org.toqa.accounts.SessionStore;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.OrderArchive;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskTraces;
import org.toqa.fleet.history.EventArchive;
import org.toqa.fleet.history.StatisticsArchive;
import org.toqa.fleet.history.TrackStore;

/** What the web application uses. Whoever starts it puts this into the servlet context. */
public record Services(
    Fleet fleet,
    TaskArchive archive,
    OrderArchive orders,
    TaskTraces traces,
    EventArchive history,
    TrackStore tracks,
    ScheduleStore schedules,
    StatisticsArchive statistics,
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

  /** The servlet context's attribute that holds the services. */
  public static final String ATTRIBUTE = Services.class.getName();

  public static Services of(ServletContext context) {
    return (Services)
        Objects.requireNonNull(
            context.getAttribute(ATTRIBUTE), "The services are not in the servlet context.");
  }
}
