package org.toqa.fleet;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.OpenTask;

/**
 * What the store knows of a floor when its agent starts.
 *
 * @param outOfService names of robots
 * @param held names of robots
 * @param charges of its robots
 * @param pause null while the fleet is not paused
 * @param hold null while the floor is not on hold
 * @param begun tasks that have robots
 */
record FloorMemory(
    List<RobotRecord> robots,
    Set<String> outOfService,
    Set<String> held,
    List<ChargeRecord> charges,
    @Nullable Hold pause,
    @Nullable Hold hold,
    List<OpenTask> begun) {}
