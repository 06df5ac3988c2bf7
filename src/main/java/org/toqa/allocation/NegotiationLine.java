package org.toqa.allocation;

import java.time.Instant;
import org.toqa.wording.Sentence;

/**
 * What happened to a task in a negotiation, for people to read.
 *
 * @param task its id
 */
public record NegotiationLine(long task, Instant at, Sentence text) {}
