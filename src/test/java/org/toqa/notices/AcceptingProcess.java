package org.toqa.notices;

import java.net.URI;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.toqa.store.Database;
import org.toqa.store.JdbiNoticeStore;
import org.toqa.wording.Sentence;

/**
 * Accepts notices for a webhook, says the id of each that is stored, and ends without a warning.
 */
final class AcceptingProcess {
  static final int NOTICES = 20;

  private AcceptingProcess() {}

  static Database open(Path file) {
    return Database.open(Database.fileUrl(file), "", "");
  }

  /**
   * @param args the file of the database, without its ending, and the webhook's address
   */
  public static void main(String[] args) {
    JdbiNoticeStore store = new JdbiNoticeStore(open(Path.of(args[0])).jdbi());
    Instant now = Instant.now();
    store.addWebhook(URI.create(args[1]), WebhookSecret.random(), NoticeKind.ALL, now, "Max");
    for (int i = 0; i < NOTICES; i++) {
      Notice notice =
          new Notice(
              0,
              UUID.randomUUID(),
              new Condition(
                  NoticeKind.SERVER, "x" + i, null, null, null, null, Sentence.verbatim("x")),
              now,
              null);
      DeliveryPlan plan = new DeliveryPlan(store.people(), store.webhooks());
      store.add(List.of(plan.change(notice, false, now)), now, _ -> false);
      System.out.println(notice.uid());
    }
    Runtime.getRuntime().halt(137);
  }
}
