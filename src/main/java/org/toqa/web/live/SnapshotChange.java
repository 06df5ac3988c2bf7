package org.toqa.web.live;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * What makes one snapshot the next: only the members that changed. Of robots, tasks and floors only
 * those that changed are there, each with its key and the members that changed; where some came,
 * went or moved, {@code order} has the keys of all.
 */
final class SnapshotChange {
  private static final Map<String, String> KEYS =
      Map.of("robots", "name", "tasks", "id", "floors", "floor");

  private final ObjectNode before;
  private final ObjectNode now;
  private final ObjectNode change = JsonNodeFactory.instance.objectNode();
  private final ObjectNode order = JsonNodeFactory.instance.objectNode();

  private SnapshotChange(ObjectNode before, ObjectNode now) {
    this.before = before;
    this.now = now;
  }

  static ObjectNode between(ObjectNode before, ObjectNode now) {
    return new SnapshotChange(before, now).compute();
  }

  private ObjectNode compute() {
    now.properties()
        .forEach(
            member -> {
              String key = KEYS.get(member.getKey());
              if (key == null) {
                putIfChanged(change, before, member);
              } else {
                compareLists(member.getKey(), key);
              }
            });
    if (!order.isEmpty()) {
      change.set("order", order);
    }
    return change;
  }

  private void compareLists(String list, String key) {
    Map<JsonNode, ObjectNode> old = new HashMap<>();
    before.get(list).forEach(item -> old.put(item.get(key), (ObjectNode) item));
    ArrayNode changed = JsonNodeFactory.instance.arrayNode();
    for (JsonNode item : now.get(list)) {
      ObjectNode part = changedMembers((ObjectNode) item, old.get(item.get(key)), key);
      if (part.size() > 1) {
        changed.add(part);
      }
    }
    if (!changed.isEmpty()) {
      change.set(list, changed);
    }
    ArrayNode keys = keys(now.get(list), key);
    if (!keys.equals(keys(before.get(list), key))) {
      order.set(list, keys);
    }
  }

  private static ObjectNode changedMembers(ObjectNode item, @Nullable ObjectNode old, String key) {
    if (old == null) {
      return item;
    }
    ObjectNode part = JsonNodeFactory.instance.objectNode().set(key, item.get(key));
    item.properties().forEach(member -> putIfChanged(part, old, member));
    return part;
  }

  private static void putIfChanged(
      ObjectNode change, ObjectNode old, Map.Entry<String, JsonNode> member) {
    if (!member.getValue().equals(old.get(member.getKey()))) {
      change.set(member.getKey(), member.getValue());
    }
  }

  private static ArrayNode keys(JsonNode list, String key) {
    ArrayNode keys = JsonNodeFactory.instance.arrayNode();
    list.forEach(item -> keys.add(item.get(key)));
    return keys;
  }
}
