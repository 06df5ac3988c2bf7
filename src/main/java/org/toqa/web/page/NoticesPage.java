package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.toqa.notices.Channel;
import org.toqa.notices.Delivery;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticePreferences;
import org.toqa.notices.NoticeStore.Entry;
import org.toqa.notices.Notices;
import org.toqa.web.access.Caller;
import org.toqa.web.api.NoticesResource;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.NoticePreferencesReader;
import org.toqa.web.input.NoticeQueryReader;

/** The inbox of notices, and how its reader wants to be told. */
public final class NoticesPage extends PageHandler {
  private static final int PAGE_SIZE = 50;

  /**
   * A notice as the page shows it.
   *
   * @param seen whether its reader has seen it
   * @param deliveries those that he may know of: of letters to others only managers do
   */
  public record Line(Entry entry, boolean seen, List<Delivery.Outcome> deliveries) {
    static Line of(Entry entry, Caller caller) {
      long account = caller.account().id();
      return new Line(
          entry,
          entry.isSeenBy(account),
          caller.isManager()
              ? entry.deliveries()
              : entry.deliveries().stream()
                  .filter(one -> one.receiver().equals(new Receiver.OfPerson(account)))
                  .toList());
    }
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    NoticeQueryReader reader = new NoticeQueryReader(request, errors);
    Caller caller = Caller.of(request);
    List<Entry> entries =
        services(request).notices().store().entries(reader.filter(), reader.before(), PAGE_SIZE);
    request.setAttribute("shown", reader.show().name().toLowerCase(Locale.ROOT));
    request.setAttribute("lines", entries.stream().map(entry -> Line.of(entry, caller)).toList());
    if (!entries.isEmpty()) {
      request.setAttribute("newest", entries.getFirst().notice().id());
    }
    if (entries.size() == PAGE_SIZE) {
      request.setAttribute("next", entries.getLast().notice().id());
    }
    showList(request, response, "notices", errors);
  }

  /** One, or all up to the newest that was shown. */
  public static void see(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Caller caller = Caller.of(request);
    Notices notices = services(request).notices();
    Optional<Long> one = id(request, "id");
    Optional<Long> upTo = id(request, "upTo");
    boolean isDone =
        one.map(id -> notices.markSeen(id, caller.account().id(), caller.name()))
            .orElse(upTo.isPresent());
    upTo.ifPresent(id -> notices.markAllSeen(id, caller.account().id(), caller.name()));
    if (isDone) {
      String show = request.getParameter("show");
      redirect(
          request,
          response,
          "/notices" + ("open".equals(show) || "unseen".equals(show) ? "?show=" + show : ""));
    } else {
      sendNotFound(request, response, "problem.noSuchNotice");
    }
  }

  private static Optional<Long> id(HttpServletRequest request, String name) {
    return Optional.ofNullable(request.getParameter(name))
        .filter(text -> text.matches("[1-9][0-9]{0,17}"))
        .map(Long::valueOf);
  }

  public static void showSettings(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addSettings(request, NoticesResource.preferences(request));
    show(request, response, "notice-settings");
  }

  public static void saveSettings(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    NoticePreferences read = NoticePreferencesReader.read(fields, fields::has);
    if (errors.isEmpty()) {
      services(request).notices().setPreferences(Caller.of(request).account().id(), read);
      redirect(request, response, "/notices/settings?done=saved");
    } else {
      addSettings(request, read);
      showAgain(request, response, "notice-settings", errors);
    }
  }

  private static void addSettings(HttpServletRequest request, NoticePreferences preferences) {
    request.setAttribute("preferences", preferences);
    request.setAttribute("kinds", NoticeKind.values());
    request.setAttribute("channels", Channel.values());
    request.setAttribute("canMail", services(request).notices().canMail());
  }
}
