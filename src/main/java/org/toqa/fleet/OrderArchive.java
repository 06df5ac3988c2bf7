package org.toqa.fleet;

import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** Reads stored orders with all their tasks. Called by threads that may wait. */
public interface OrderArchive {

  Optional<OrderView> order(long id);

  /** Those of them that there are, newest first. */
  List<OrderView> orders(Collection<Long> ids);

  /** Newest first. */
  List<OrderView> orders(int offset, int limit);

  long orderCount();
}
