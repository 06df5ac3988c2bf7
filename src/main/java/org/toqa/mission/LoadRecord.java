package org.toqa.mission;

import java.time.Instant;

/**
 * Which load a task has, and since when that is where it is now.
 *
 * @param id that of the first task that had it: a load which was set down and is fetched for
 *     another task stays the same one
 */
public record LoadRecord(long id, Instant since) {}
