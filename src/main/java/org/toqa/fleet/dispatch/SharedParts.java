package org.toqa.fleet.dispatch;

import java.time.InstantSource;
import org.toqa.allocation.AllocationMethod;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.link.RobotLinkFactory;

/**
 * What all floors of a fleet have in common.
 *
 * @param method by which a floor's rounds are held where nobody has chosen another
 * @param clock for the times in the history
 */
public record SharedParts(
    FleetStore store,
    RobotLinkFactory links,
    AllocationMethod method,
    FleetRules rules,
    InstantSource clock,
    FleetRuntime runtime,
    OrderChecks checks,
    PendingSubmissions pendingSubmissions,
    TaskFloors taskFloors,
    StoreHealthCheck storeHealth) {}
