package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.toqa.endtoend.WorkLedger.Answer;
import org.toqa.testbed.ApiClient.Reply;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Maps that are published while the server fails. They differ in the speed of one area where nobody
 * drives fast, so that each can be told from the others.
 */
final class PublishedMaps {
  private static final long LIMIT_NANOS = TimeUnit.MINUTES.toNanos(2);
  private static final String FLOOR = "floors/" + CrashTestbed.FLOOR;

  private final CrashTestbed site;

  /** What is drawn but for that area; null: nothing was published yet. */
  private JsonNode rest;

  /** The speeds that may be in force, millimetres a second. */
  private final Set<Long> possible = new HashSet<>();

  private long next;

  /**
   * @param first a speed that no other run's maps have, millimetres a second
   */
  PublishedMaps(CrashTestbed site, long first) {
    this.site = site;
    this.next = first;
  }

  /**
   * Draws another map, and asks for it.
   *
   * @return the answer, which may come while the server fails
   */
  CompletableFuture<Reply> publish() throws Exception {
    if (rest == null) {
      JsonNode inForce = site.server.await(FLOOR, found -> true).get("drawing");
      rest = withoutSpeed(inForce);
      possible.add(speed(inForce));
    }
    next++;
    JsonNode draft = saveDraft();
    return site.server
        .api()
        .replyLater(
            FLOOR + "/draft/publish",
            JsonNodeFactory.instance.objectNode().put("revision", draft.get("revision").asLong()));
  }

  /** With the next speed; the database may still be away from the fault before. */
  private JsonNode saveDraft() throws Exception {
    long end = System.nanoTime() + LIMIT_NANOS;
    while (true) {
      JsonNode draft = site.server.await(FLOOR + "/draft", found -> true);
      ObjectNode drawing = (ObjectNode) draft.get("drawing").deepCopy();
      ArrayNode limits = drawing.putArray("speedLimits");
      ObjectNode area = limits.addObject();
      area.put("x", 0.3).put("y", 4.5).put("width", 0.3).put("height", 0.3);
      area.put("speed", next / 1000.0);
      ObjectNode change = drawing.objectNode().put("revision", draft.get("revision").asLong());
      change.set("drawing", drawing);
      Reply saved = site.server.api().put(FLOOR + "/draft", change);
      if (saved.isAccepted()) {
        return saved.body();
      }
      assertTrue(saved.isUnavailable() && System.nanoTime() < end, saved::toString);
      TimeUnit.MILLISECONDS.sleep(50);
    }
  }

  /** What became of the last one. */
  void add(Answer answer) {
    if (answer == Answer.ACCEPTED) {
      possible.clear();
    }
    if (answer != Answer.REFUSED) {
      possible.add(next);
    }
  }

  /** One of the maps that may be in force is, as a whole; and it is the one that robots have. */
  void judge() throws IOException, InterruptedException, Exception {
    if (rest == null) {
      return;
    }
    JsonNode floor = site.server.await(FLOOR, found -> true);
    JsonNode drawing = floor.get("drawing");
    assertEquals(rest, withoutSpeed(drawing));
    assertTrue(possible.contains(speed(drawing)), () -> speed(drawing) + " of " + possible);
    site.server.await(
        "map?floor=" + CrashTestbed.FLOOR,
        map -> map.get("speedLimits").equals(drawing.get("speedLimits")));
  }

  private static JsonNode withoutSpeed(JsonNode drawing) {
    ObjectNode copy = (ObjectNode) drawing.deepCopy();
    copy.remove("speedLimits");
    return copy;
  }

  /** 0 where there is none. */
  private static long speed(JsonNode drawing) {
    JsonNode limits = drawing.get("speedLimits");
    return limits.isEmpty() ? 0 : Math.round(limits.get(0).get("speed").asDouble() * 1000);
  }
}
