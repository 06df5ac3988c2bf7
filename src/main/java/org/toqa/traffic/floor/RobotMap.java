package org.toqa.traffic.floor;

import java.util.AbstractCollection;
import java.util.AbstractMap;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.Spliterator;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * What is known of robots by their names: gone through in the order of these, and found by hash,
 * since each tick asks for each robot many times. Its keys, values and entries only tell.
 */
public final class RobotMap<V> extends AbstractMap<String, V> {
  private final Map<String, V> inOrder = new TreeMap<>();
  private final Map<String, V> byHash = new HashMap<>();

  /** The values in that order; null: not asked for since one came or went. */
  private @Nullable List<V> listed;

  private final Collection<V> values = new Values();

  /** Shows what is there at any time; who goes through them has those that were there then. */
  private final class Values extends AbstractCollection<V> {
    @Override
    public Iterator<V> iterator() {
      return list().iterator();
    }

    @Override
    public Spliterator<V> spliterator() {
      return list().spliterator();
    }

    @Override
    public void forEach(Consumer<? super V> action) {
      list().forEach(action);
    }

    @Override
    public int size() {
      return byHash.size();
    }
  }

  private List<V> list() {
    List<V> known = listed;
    if (known == null) {
      known = Collections.unmodifiableList(new ArrayList<>(inOrder.values()));
      listed = known;
    }
    return known;
  }

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
    listed = null;
    return byHash.put(name, value);
  }

  @Override
  public @Nullable V remove(Object name) {
    inOrder.remove(name);
    listed = null;
    return byHash.remove(name);
  }

  @Override
  public Set<String> keySet() {
    return Collections.unmodifiableSet(inOrder.keySet());
  }

  @Override
  public Collection<V> values() {
    return values;
  }

  @Override
  public Set<Entry<String, V>> entrySet() {
    return Collections.unmodifiableMap(inOrder).entrySet();
  }
}
