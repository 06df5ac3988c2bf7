package org.toqa.grid;

/** A part of a floor where robots drive in one direction, or across it, and never against it. */
public record OneWay(Area area, Direction direction) {}
