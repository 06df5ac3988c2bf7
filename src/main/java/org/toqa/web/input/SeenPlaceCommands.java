package org.toqa.web.input;

import java.util.BitSet;
import java.util.Optional;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.history.SeenPlaces;
import org.toqa.fleet.history.SeenPlaces.Offer;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Services;
import org.toqa.wording.Phrase;

/** What a person makes of what robots saw, by a form or by the API. */
public final class SeenPlaceCommands {
  private final Services services;

  public SeenPlaceCommands(Services services) {
    this.services = services;
  }

  private Optional<FloorMap> floor(String name) {
    return services.fleet().floors().stream().filter(f -> f.name().equals(name)).findFirst();
  }

  private Optional<Offer> offer(String floor, String id) {
    return floor(floor).flatMap(map -> services.seenPlaces().offer(map, id));
  }

  private static <T> Answer<T> gone() {
    return new Answer.Unknown<>(Phrase.NO_SUCH_SIGHTING.with());
  }

  /** Draws it into the floor's draft, where it is seen as a difference and published. */
  public Answer<FloorDraft> draw(String floor, String id, String user) {
    FloorEditing editing = services.fleet().floorEditing();
    Optional<Offer> offer = offer(floor, id);
    Optional<FloorDraft> draft = editing.draft(floor);
    if (offer.isEmpty() || draft.isEmpty()) {
      return gone();
    }
    OccupancyGrid walls = draft.get().drawing().walls();
    BitSet occupied = walls.occupied();
    for (Vec2 cell : offer.get().cells()) {
      if (walls.contains(walls.cellAt(cell))) {
        occupied.set(walls.index(walls.cellAt(cell)));
      }
    }
    return FleetAnswers.await(
        editing.saveDraft(
            floor,
            draft.get().drawing().withWalls(walls.withOccupied(occupied)),
            draft.get().revision(),
            user));
  }

  /** The map stays as it is there. */
  public Answer<Offer> dismiss(String floor, String id) {
    SeenPlaces places = services.seenPlaces();
    Optional<Offer> offer = offer(floor, id);
    if (offer.isEmpty()) {
      return gone();
    }
    places.dismiss(floor(floor).orElseThrow(), offer.get());
    return new Answer.Accepted<>(offer.get());
  }
}
