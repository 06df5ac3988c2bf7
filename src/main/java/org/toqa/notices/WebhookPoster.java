package org.toqa.notices;

import java.io.IOException;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.UUID;

/** Tells webhooks, by signed requests. */
public final class WebhookPoster implements AutoCloseable {
  private final String site;
  private final InstantSource clock;
  private final WebhookClient client;

  /**
   * @param site its name, which webhooks are told
   * @param addresses where they may lead
   */
  public WebhookPoster(String site, WebhookAddresses addresses, InstantSource clock) {
    this.site = site;
    this.clock = clock;
    this.client = new WebhookClient(addresses);
  }

  /**
   * Returns when the receiver has taken it.
   *
   * @throws WebhookException it did not
   */
  void post(Webhook webhook, Delivery delivery, Notice notice) throws WebhookException {
    post(webhook, delivery.uid(), NoticeMessage.json(site, notice, delivery.ending()));
  }

  /**
   * Tells that nothing has happened, so that a person sees whether it arrives.
   *
   * @throws WebhookException it does not
   */
  public void postTest(Webhook webhook) throws WebhookException {
    Instant now = clock.instant();
    post(webhook, UUID.randomUUID(), NoticeMessage.test(site, now));
  }

  private void post(Webhook webhook, UUID uid, String body) throws WebhookException {
    String id = uid.toString();
    long stamp = clock.instant().getEpochSecond();
    client.post(
        webhook.url(),
        body,
        Map.of(
            "webhook-id", id,
            "webhook-timestamp", Long.toString(stamp),
            "webhook-signature", webhook.secret().signature(id, stamp, body)));
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}
