package org.toqa.allocation;

import org.toqa.geometry.Vec2;

/**
 * A robot as an allocator sees it.
 *
 * @param maxLoad kilograms
 * @param position metres, map frame
 * @param available whether it can be given a task now: idle, or on its way home
 */
public record Candidate(String robot, double maxLoad, Vec2 position, boolean available) {}
