package org.toqa.camera;

import java.net.URI;
import org.jspecify.annotations.Nullable;

/** A camera as it is stored. */
public record Camera(long id, CameraOrder order) {

  public String name() {
    return order.name();
  }

  /** Where it answers; it may have a password in it, and so is for managers. */
  public URI url() {
    return order.url();
  }

  /** Null: it watches a floor. */
  public @Nullable String robot() {
    return order.robot();
  }

  /** Null: it is on a robot. */
  public @Nullable String floor() {
    return order.floor();
  }
}
