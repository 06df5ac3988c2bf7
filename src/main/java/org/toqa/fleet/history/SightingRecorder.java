package org.toqa.fleet.history;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.PeriodicWork;
import org.toqa.fleet.history.SeenPlaces.Sighting;
import org.toqa.fleet.history.SeenPlaces.Spot;
import org.toqa.grid.FloorMap;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Sentence;

/** Watches what robots see, and stores it now and then. */
public final class SightingRecorder implements FloorListener, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(SightingRecorder.class);

  /** An obstacle is remembered for longer by the floor. */
  private static final Duration OBSERVE_INTERVAL = Duration.ofSeconds(5);

  private static final int OBSERVATIONS_PER_WRITE = 12;

  private final Fleet fleet;
  private final SeenPlaces places;
  private final SightingStore store;
  private final InstantSource clock;
  private final PeriodicWork work;
  private int observations;

  public SightingRecorder(
      Fleet fleet, SeenPlaces places, SightingStore store, InstantSource clock) {
    this.fleet = fleet;
    this.places = places;
    this.store = store;
    this.clock = clock;
    this.work = new PeriodicWork("sightings", OBSERVE_INTERVAL, this::observe);
  }

  private synchronized void observe() {
    FleetSnapshot snapshot = fleet.snapshots().latest();
    for (FloorMap floor : fleet.floors()) {
      for (FloorView view : snapshot.floors()) {
        if (view.name().equals(floor.name())) {
          places.observe(floor, view, snapshot.robots(), clock.instant());
        }
      }
    }
    observations++;
    if (observations % OBSERVATIONS_PER_WRITE == 0) {
      write();
    }
  }

  @Override
  public Optional<Sentence> objectionToRemoval(String floor) {
    return Optional.empty();
  }

  /** Not while something is observed, which may still be on that floor. */
  @Override
  public synchronized void floorRemoved(String floor) {
    places.forget(floor);
    write();
  }

  private void write() {
    places.takeChanged().ifPresent(this::write);
  }

  private synchronized void writeLast() {
    write();
  }

  private void write(Map<Spot, Sighting> sightings) {
    try {
      store.replace(sightings);
    } catch (StoreException e) {
      log.warn("What robots have seen could not be stored; it waits.", e);
      places.setChanged();
    }
  }

  @Override
  public void close() {
    work.close();
    writeLast();
  }
}
