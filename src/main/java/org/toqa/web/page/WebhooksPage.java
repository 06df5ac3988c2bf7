package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.Delivery;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticeStore;
import org.toqa.notices.Notices;
import org.toqa.notices.Webhook;
import org.toqa.notices.WebhookException;
import org.toqa.notices.WebhookSecret;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.WebhookReader;
import org.toqa.web.input.WebhookReader.WebhookOrder;

/** The webhooks of a site, for its managers. */
public final class WebhooksPage extends PageHandler {
  private static final String VIEW = "webhooks";
  private static final String PATH = "/notices/webhooks";
  private static final String SECRET = "webhookSecret";

  /**
   * A webhook as the page shows it.
   *
   * @param last what became of what was told there last; null: nothing was yet
   */
  public record Line(Webhook webhook, Delivery.@Nullable Outcome last) {}

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    ShownOnce.of(request.getServletContext())
        .take(Caller.of(request), SECRET)
        .ifPresent(secret -> request.setAttribute("secret", secret));
    show(request, response, VIEW);
  }

  private static void addAttributes(HttpServletRequest request) {
    NoticeStore store = services(request).notices().store();
    Map<Long, Delivery.Outcome> last = store.lastOutcomes();
    List<Line> lines =
        store.webhooks().stream()
            .map(webhook -> new Line(webhook, last.get(webhook.id())))
            .toList();
    request.setAttribute("lines", lines);
    request.setAttribute("kinds", NoticeKind.values());
    request.setAttribute("most", Webhook.MOST);
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Notices notices = services(request).notices();
    Optional<WebhookOrder> order =
        readForm(request, errors, fields -> WebhookReader.read(fields, notices.addresses()));
    if (order.isPresent() && notices.store().webhooks().size() >= Webhook.MOST) {
      errors.add(FORM, Texts.of(request).get("error.webhooks.many", Webhook.MOST));
    }
    if (order.isEmpty() || !errors.isEmpty()) {
      showAgainWith(request, response, errors, null);
      return;
    }
    WebhookSecret secret = WebhookSecret.random();
    notices
        .store()
        .addWebhook(
            order.get().url(),
            secret,
            order.get().kinds(),
            services(request).clock().instant(),
            Caller.of(request).name());
    showSecretOnce(request, secret);
    redirect(request, response, PATH + "?done=added");
  }

  private static void showAgainWith(
      HttpServletRequest request,
      HttpServletResponse response,
      FieldErrors errors,
      @Nullable Webhook sent)
      throws ServletException, IOException {
    addAttributes(request);
    if (sent != null) {
      request.setAttribute("sent", sent.id());
    }
    showAgain(request, response, VIEW, errors);
  }

  private static void showSecretOnce(HttpServletRequest request, WebhookSecret secret) {
    ShownOnce.of(request.getServletContext()).put(Caller.of(request), SECRET, secret.text());
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Webhook> webhook = webhook(request, response);
    if (webhook.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    Notices notices = services(request).notices();
    Optional<WebhookOrder> order =
        readForm(request, errors, fields -> WebhookReader.read(fields, notices.addresses()));
    if (order.isEmpty()) {
      showAgainWith(request, response, errors, webhook.get());
      return;
    }
    notices
        .store()
        .changeWebhook(
            webhook.get().id(),
            order.get().url(),
            order.get().kinds(),
            request.getParameter("enabled") != null,
            services(request).clock().instant(),
            Caller.of(request).name());
    redirect(request, response, PATH + "?done=changed");
  }

  public static void renewSecret(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Webhook> webhook = webhook(request, response);
    if (webhook.isPresent()) {
      WebhookSecret secret = WebhookSecret.random();
      services(request)
          .notices()
          .store()
          .setSecret(
              webhook.get().id(),
              secret,
              services(request).clock().instant(),
              Caller.of(request).name());
      showSecretOnce(request, secret);
      redirect(request, response, PATH + "?done=secret");
    }
  }

  /** Whether it arrives is told at once. */
  public static void test(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Webhook> webhook = webhook(request, response);
    if (webhook.isEmpty()) {
      return;
    }
    try {
      services(request).notices().webhooks().postTest(webhook.get());
      redirect(request, response, PATH + "?done=tested");
    } catch (WebhookException e) {
      FieldErrors errors = new FieldErrors();
      Texts texts = Texts.of(request);
      errors.add(FORM, texts.get("error.webhooks.test", texts.text(e.sentence())));
      showAgainWith(request, response, errors, webhook.get());
    }
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Webhook> webhook = webhook(request, response);
    if (webhook.isPresent()) {
      services(request)
          .notices()
          .store()
          .deleteWebhook(
              webhook.get().id(), services(request).clock().instant(), Caller.of(request).name());
      redirect(request, response, PATH + "?done=deleted");
    }
  }

  /** The webhook in the path; empty when the answer is given: there is none. */
  private static Optional<Webhook> webhook(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    long id = RequestPath.number(request, "id");
    Optional<Webhook> found =
        services(request).notices().store().webhooks().stream()
            .filter(webhook -> webhook.id() == id)
            .findFirst();
    if (found.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchWebhook");
    }
    return found;
  }
}
