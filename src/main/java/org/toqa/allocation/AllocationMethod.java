package org.toqa.allocation;

/** How a floor's rounds are held. */
public sealed interface AllocationMethod {

  /** One function decides over all tasks and robots. */
  record Computed(Allocator allocator) implements AllocationMethod {}

  /** Robots' agents are asked, in a {@link Negotiation}. */
  record Negotiated() implements AllocationMethod {}
}
