package org.toqa.motion;

/**
 * Room beside a path that is a robot's own for a while, to drive round what it sees there.
 *
 * @param from the first segment of the path beside which it is, counted from 0
 * @param to the first one beside which it is not any more
 * @param left metres that the robot's middle may be to the left of its path
 * @param right metres that it may be to the right
 */
public record PassingRoom(int from, int to, double left, double right) {}
