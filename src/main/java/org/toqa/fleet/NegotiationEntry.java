package org.toqa.fleet;

import java.time.Instant;
import org.toqa.wording.Sentence;

/** What was said of a task in a negotiation with robots' agents. */
public record NegotiationEntry(Instant at, Sentence text) {}
