package org.toqa.app.server;

import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.ConcurrentHashMap;
import org.apache.tomcat.util.net.SocketWrapperBase;

/**
 * Since when the requests have been coming in that are not complete, by connection; by {@link
 * System#nanoTime}. Any thread may ask.
 */
final class ReceivedRequests {
  /** Those of which a thread reads. */
  private final Map<SocketWrapperBase<?>, TimedProcessor> read = new ConcurrentHashMap<>();

  /** Those that wait for the rest of a header, or for a header behind empty lines. */
  private final Map<SocketWrapperBase<?>, Long> parted = new ConcurrentHashMap<>();

  void begin(SocketWrapperBase<?> connection, TimedProcessor processor) {
    read.put(connection, processor);
  }

  /**
   * There is no more to read of it now.
   *
   * @param isParted whether a part of a request has come
   * @param isServed whether others were answered before
   */
  void end(SocketWrapperBase<?> connection, boolean isParted, boolean isServed) {
    read.remove(connection);
    if (!isParted) {
      parted.remove(connection);
    } else if (isServed) {
      parted.put(connection, System.nanoTime());
    } else {
      parted.putIfAbsent(connection, System.nanoTime());
    }
  }

  /** Empty where none is coming in. */
  OptionalLong since(SocketWrapperBase<?> connection) {
    TimedProcessor processor = read.get(connection);
    Long header = parted.get(connection);
    if (processor != null) {
      OptionalLong since = processor.receivingSince();
      return since.isPresent() && header != null ? OptionalLong.of(header) : since;
    }
    return header == null ? OptionalLong.empty() : OptionalLong.of(header);
  }

  void forgetClosed() {
    read.keySet().removeIf(SocketWrapperBase::isClosed);
    parted.keySet().removeIf(SocketWrapperBase::isClosed);
  }
}
