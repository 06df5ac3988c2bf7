package org.toqa.agent.chassis;

/**
 * How far a body has come on the path that it drives by itself. All of it is of the reference that
 * the body follows.
 *
 * @param path its number
 * @param completed how many of its segments
 * @param seconds of the next one's planned time
 * @param pace as a share of the planned speed, 0 to 1
 * @param settled whether the reference is stopped, and the body at its place
 */
public record PathProgress(
    long path, int completed, double seconds, double pace, boolean settled) {}
