package org.toqa.arm;

/**
 * How an arm shall be now; the next command, a tick later, goes on from there.
 *
 * @param angles of its joints, radians
 * @param rates how fast they turn there, radians a second
 * @param handClosed whether its hand is to be closed
 * @param goal where its joints are brought, radians: for an arm that finds its own way there
 * @param onward false: they come to a stand on their way
 */
public record ArmCommand(
    JointAngles angles, JointAngles rates, boolean handClosed, JointAngles goal, boolean onward) {}
