package org.toqa.traffic.floor;

import java.util.AbstractMap;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * What is known of robots by their names: gone through in the order of these, and found by hash,
 * since each tick asks for each robot many times. Its keys, values and entries only tell.
 */
public final class RobotMap<V> extends AbstractMap<String, V> {
  private final Map<String, V> inOrder = new TreeMap<>();
  private final Map<String, V> byHash = new HashMap<>();

  @Override
  public @Nullable V get(Object name) {
    return byHash.get(name);
  }

  @Override
  public boolean containsKey(Object name) {
    return byHash.containsKey(name);
  }

  @Override
  public @Nullable V put(String name, V value) {
    inOrder.put(name, value);
    return byHash.put(name, value);
  }

  @Override
  public @Nullable V remove(Object name) {
    inOrder.remove(name);
    return byHash.remove(name);
  }

  @Override
  public Set<String> keySet() {
    return Collections.unmodifiableSet(inOrder.keySet());
  }

  @Override
  public Collection<V> values() {
    return Collections.unmodifiableCollection(inOrder.values());
  }

  @Override
  public Set<Entry<String, V>> entrySet() {
    return Collections.unmodifiableMap(inOrder).entrySet();
  }
}
