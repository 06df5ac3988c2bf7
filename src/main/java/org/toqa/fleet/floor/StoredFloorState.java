package org.toqa.fleet.floor;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotRecord;

/**
 * What the store knows of a floor when its agent starts.
 *
 * @param robotsOutOfService names of robots
 * @param heldRobots names of robots
 * @param charges of its robots
 * @param pause null while the fleet is not paused
 * @param hold null while the floor is not on hold
 * @param begunTasks tasks that have robots
 */
public record StoredFloorState(
    List<RobotRecord> robots,
    Set<String> robotsOutOfService,
    Set<String> heldRobots,
    List<ChargeRecord> charges,
    @Nullable Hold pause,
    @Nullable Hold hold,
    List<OpenTask> begunTasks) {}
