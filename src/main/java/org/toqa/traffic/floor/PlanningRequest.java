package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.List;
import java.util.Set;

/**
 * A picture of the floor at one moment, and what is to be planned on it. Immutable: any thread may
 * read it.
 *
 * @param now the moment
 * @param robots all, by name; copies that nobody changes
 * @param dueForOwnPath the names of those that are to be looked for a path of their own
 * @param need whether all are to be planned together
 */
record PlanningRequest(
    Instant now,
    Obstacles obstacles,
    List<TrafficRobot> robots,
    Set<String> dueForOwnPath,
    ReplanTrigger.Need need) {}
