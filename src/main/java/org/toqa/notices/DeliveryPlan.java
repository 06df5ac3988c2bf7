package org.toqa.notices;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.notices.NoticeStore.Change;

/**
 * Who is to be told what.
 *
 * @param people who may be told by letter
 */
record DeliveryPlan(List<Person> people, List<Webhook> webhooks) {

  static final DeliveryPlan NOBODY = new DeliveryPlan(List.of(), List.of());

  DeliveryPlan {
    people = List.copyOf(people);
    webhooks = List.copyOf(webhooks);
  }

  Optional<Person> person(long account) {
    return people.stream().filter(one -> one.id() == account).findFirst();
  }

  Optional<Webhook> webhook(long id) {
    return webhooks.stream().filter(one -> one.id() == id).findFirst();
  }

  /** The notice, or its end, with all that is to be told of it. */
  Change change(Notice notice, boolean ending, Instant now) {
    return new Change(notice, ending, deliveries(notice, ending, now));
  }

  private List<Delivery> deliveries(Notice notice, boolean ending, Instant now) {
    List<Delivery> planned = new ArrayList<>();
    for (Person person : people) {
      NoticePreferences preferences = person.preferences();
      if (preferences.wants(notice.condition(), Channel.EMAIL, person.id())
          && (!ending || preferences.ends())) {
        planned.add(
            new Delivery(
                UUID.randomUUID(),
                new Receiver.OfPerson(person.id()),
                ending,
                preferences.whenDisturbable(now)));
      }
    }
    for (Webhook webhook : webhooks) {
      if (webhook.wants(notice.condition())) {
        planned.add(
            new Delivery(UUID.randomUUID(), new Receiver.OfWebhook(webhook.id()), ending, now));
      }
    }
    return List.copyOf(planned);
  }
}
