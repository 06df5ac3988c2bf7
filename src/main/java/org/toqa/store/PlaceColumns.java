package org.toqa.store;

import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;

/**
 * Where a load is fetched or brought, as it is kept in columns.
 *
 * @param x metres, map frame; 0 where the station alone was given
 * @param y like {@code x}
 * @param station null: it was given by coordinates
 */
record PlaceColumns(double x, double y, @Nullable String station) {

  TaskPlace toTaskPlace() {
    return new TaskPlace(new Vec2(x, y), station);
  }

  Where toWhere() {
    return station == null ? new Where.Point(new Vec2(x, y)) : new Where.Station(station);
  }
}
