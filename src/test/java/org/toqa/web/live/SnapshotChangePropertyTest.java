package org.toqa.web.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Whoever puts changes together as the API's document says has what was sent whole. */
class SnapshotChangePropertyTest {
  private static final JsonMapper JSON = JsonMapper.shared();

  private static final Map<String, String> KEYS =
      Map.of("robots", "name", "tasks", "id", "floors", "floor");

  @Property
  void theOneBeforeAndTheChangeAreTheNext(
      @ForAll("snapshots") ObjectNode before, @ForAll("snapshots") ObjectNode now) {
    ObjectNode change = SnapshotChange.between(before, now);

    assertEquals(now, putTogether(before.deepCopy(), change));
  }

  @Property
  void whatIsTheSameIsNotSent(@ForAll("snapshots") ObjectNode snapshot) {
    assertTrue(SnapshotChange.between(snapshot, snapshot.deepCopy()).isEmpty());
  }

  @Property
  void ofAPartOnlyWhatChangedIsSent(@ForAll("snapshots") ObjectNode snapshot) {
    ObjectNode now = snapshot.deepCopy();
    now.get("robots").forEach(robot -> ((ObjectNode) robot).put("pose", "elsewhere"));

    ObjectNode change = SnapshotChange.between(snapshot, now);

    assertTrue(change.isEmpty() || names(change).equals(Set.of("robots")));
    change.path("robots").forEach(robot -> assertEquals(Set.of("name", "pose"), names(robot)));
  }

  private static Set<String> names(JsonNode node) {
    return Set.copyOf(node.propertyNames());
  }

  private static ObjectNode putTogether(ObjectNode next, ObjectNode change) {
    change
        .properties()
        .forEach(
            member -> {
              if (!KEYS.containsKey(member.getKey()) && !member.getKey().equals("order")) {
                next.set(member.getKey(), member.getValue());
              }
            });
    KEYS.forEach((list, key) -> next.set(list, list(next.get(list), change, list, key)));
    return next;
  }

  private static ArrayNode list(JsonNode before, ObjectNode change, String list, String key) {
    Map<JsonNode, ObjectNode> parts = new HashMap<>();
    List<JsonNode> order = new ArrayList<>();
    before.forEach(part -> parts.put(part.get(key), (ObjectNode) part));
    before.forEach(part -> order.add(part.get(key)));
    for (JsonNode part : change.path(list)) {
      parts.computeIfAbsent(part.get(key), _ -> JSON.createObjectNode()).setAll((ObjectNode) part);
    }
    if (change.path("order").has(list)) {
      order.clear();
      change.get("order").get(list).forEach(order::add);
    }
    ArrayNode next = JSON.createArrayNode();
    order.forEach(name -> next.add(parts.get(name)));
    return next;
  }

  @Provide
  Arbitrary<ObjectNode> snapshots() {
    return Combinators.combine(
            Arbitraries.integers().between(0, 3),
            parts("name", "r1", "r2", "r3", "r4"),
            parts("id", 1L, 2L, 3L, 4L, 5L),
            parts("floor", "hall", "yard"))
        .as(
            (queued, robots, tasks, floors) -> {
              ObjectNode snapshot = JSON.createObjectNode().put("queued", queued);
              snapshot.set("robots", robots);
              snapshot.set("tasks", tasks);
              snapshot.set("floors", floors);
              return snapshot;
            });
  }

  private static Arbitrary<ArrayNode> parts(String key, Object... keys) {
    return Combinators.combine(
            Arbitraries.of(keys).map(JSON::<JsonNode>valueToTree),
            Arbitraries.of("here", "there").injectNull(0.3),
            Arbitraries.integers().between(0, 2).list().ofMaxSize(2))
        .as(
            (name, pose, route) -> {
              ObjectNode part = JSON.createObjectNode();
              part.set(key, name);
              part.put("pose", pose);
              part.set("route", JSON.valueToTree(route));
              return part;
            })
        .list()
        .ofMaxSize(keys.length)
        .uniqueElements(part -> part.get(key))
        .map(list -> JSON.createArrayNode().addAll(list));
  }
}
