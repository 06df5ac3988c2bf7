package org.toqa.web;

import jakarta.servlet.ServletContext;
import java.time.InstantSource;
import java.util.Objects;
import org.toqa.fleet.EventArchive;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TrackStore;
import org.toqa.store.Accounts;
import org.toqa.store.Sessions;
import org.toqa.store.Statistics;
import org.toqa.web.access.Login;
import org.toqa.web.access.PasswordLinks;
import org.toqa.web.access.Passwords;
import org.toqa.web.access.RequestLimit;

/** What the web application stands on. Whoever starts it puts this into the servlet context. */
public record Services(
    Fleet fleet,
    TaskArchive archive,
    EventArchive history,
    TrackStore tracks,
    ScheduleStore schedules,
    Statistics statistics,
    Accounts accounts,
    Sessions sessions,
    PasswordLinks passwordLinks,
    Passwords passwords,
    Metrics metrics,
    RequestLimit requestLimit,
    InstantSource clock,
    Login login,
    Submissions submissions) {

  /** The servlet context's attribute that holds the services. */
  public static final String ATTRIBUTE = Services.class.getName();

  public static Services of(
      Fleet fleet,
      TaskArchive archive,
      EventArchive history,
      TrackStore tracks,
      ScheduleStore schedules,
      Statistics statistics,
      Accounts accounts,
      Sessions sessions,
      PasswordLinks passwordLinks,
      Passwords passwords,
      Metrics metrics,
      RequestLimit requestLimit,
      InstantSource clock) {
    return new Services(
        fleet,
        archive,
        history,
        tracks,
        schedules,
        statistics,
        accounts,
        sessions,
        passwordLinks,
        passwords,
        metrics,
        requestLimit,
        clock,
        Login.of(accounts, passwords, clock),
        new Submissions(fleet, archive));
  }

  public static Services from(ServletContext context) {
    return (Services)
        Objects.requireNonNull(
            context.getAttribute(ATTRIBUTE), "The services are not in the servlet context.");
  }
}
