package org.toqa.fleet.floor;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.Hold;
import org.toqa.fleet.StoredRobot;

/**
 * What the store knows of a floor when its agent starts.
 *
 * @param pause null while the fleet is not paused
 * @param hold null while the floor is not on hold
 * @param begunTasks tasks that have robots
 * @param leftLoads ended tasks whose loads lie on the floor
 */
public record StoredFloorState(
    List<StoredRobot> robots,
    @Nullable Hold pause,
    @Nullable Hold hold,
    List<OpenTask> begunTasks,
    List<OpenTask> leftLoads) {}
