package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.Map;
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
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.WebhookReader;
import org.toqa.web.input.WebhookReader.WebhookOrder;

/** The webhooks of a site, for its managers. Their secrets are told once. */
public final class WebhooksResource extends ApiHandler {

  /**
   * @param secret null but when it was just made
   * @param last null: nothing was told there yet
   */
  private record WebhookJson(
      long id,
      String url,
      List<String> kinds,
      boolean enabled,
      Instant createdAt,
      String createdBy,
      @Nullable String secret,
      @Nullable LastJson last) {
    static WebhookJson of(
        Webhook webhook, @Nullable WebhookSecret shown, Delivery.@Nullable Outcome last) {
      return new WebhookJson(
          webhook.id(),
          webhook.url().toString(),
          webhook.kinds().stream().map(NoticeKind::word).sorted().toList(),
          webhook.enabled(),
          webhook.createdAt(),
          webhook.createdBy(),
          shown == null ? null : shown.text(),
          last == null ? null : LastJson.of(last));
    }
  }

  private record LastJson(
      String state, int failures, @Nullable Instant at, @Nullable String failure) {
    static LastJson of(Delivery.Outcome last) {
      return new LastJson(last.state().name(), last.attempts(), last.doneAt(), last.failure());
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    NoticeStore store = services(request).notices().store();
    Map<Long, Delivery.Outcome> last = store.lastOutcomes();
    Json.send(
        request,
        response,
        200,
        store.webhooks().stream()
            .map(webhook -> WebhookJson.of(webhook, null, last.get(webhook.id())))
            .toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Notices notices = services(request).notices();
    WebhookOrder order =
        readBody(
            request,
            fields -> {
              WebhookOrder read = WebhookReader.read(fields, notices.addresses());
              fields.refuseUnknown();
              return read;
            });
    if (notices.store().webhooks().size() >= Webhook.MOST) {
      throw Problem.of(409, Texts.of(request).get("error.webhooks.many", Webhook.MOST)).exception();
    }
    WebhookSecret secret = WebhookSecret.random();
    Webhook added =
        notices
            .store()
            .addWebhook(
                order.url(),
                secret,
                order.kinds(),
                services(request).clock().instant(),
                Caller.of(request).name());
    Json.send(request, response, 201, WebhookJson.of(added, secret, null));
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Webhook webhook = webhook(request);
    Notices notices = services(request).notices();
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    WebhookOrder order = WebhookReader.read(fields, notices.addresses());
    boolean enabled = fields.flag("enabled");
    fields.refuseUnknown();
    throwIfAny(errors);
    notices
        .store()
        .changeWebhook(
            webhook.id(),
            order.url(),
            order.kinds(),
            enabled,
            services(request).clock().instant(),
            Caller.of(request).name());
    Json.send(request, response, 200, WebhookJson.of(webhook(request), null, null));
  }

  public static void renewSecret(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Webhook webhook = webhook(request);
    WebhookSecret secret = WebhookSecret.random();
    services(request)
        .notices()
        .store()
        .setSecret(
            webhook.id(), secret, services(request).clock().instant(), Caller.of(request).name());
    Json.send(request, response, 200, WebhookJson.of(webhook, secret, null));
  }

  /** Whether it arrives is told at once. */
  public static void test(HttpServletRequest request, HttpServletResponse response) {
    try {
      services(request).notices().webhooks().postTest(webhook(request));
    } catch (WebhookException e) {
      Texts texts = Texts.of(request);
      throw Problem.of(502, texts.get("error.webhooks.test", texts.text(e.sentence()))).exception();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    services(request)
        .notices()
        .store()
        .deleteWebhook(
            webhook(request).id(), services(request).clock().instant(), Caller.of(request).name());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static Webhook webhook(HttpServletRequest request) {
    long id = RequestPath.number(request, "id");
    return services(request).notices().store().webhooks().stream()
        .filter(webhook -> webhook.id() == id)
        .findFirst()
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchWebhook")).exception());
  }
}
