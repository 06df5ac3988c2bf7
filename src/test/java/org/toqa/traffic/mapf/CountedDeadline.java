package org.toqa.traffic.mapf;

import java.util.concurrent.atomic.AtomicLong;
import org.toqa.traffic.Deadline;

/** A deadline that comes after it has been asked so often: time that only work passes. */
record CountedDeadline(long count) {

  Deadline deadline() {
    AtomicLong asked = new AtomicLong();
    return new Deadline(asked::getAndIncrement, count);
  }
}
