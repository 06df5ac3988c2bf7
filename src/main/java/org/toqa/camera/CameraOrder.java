package org.toqa.camera;

import java.net.URI;
import org.jspecify.annotations.Nullable;

/**
 * What a manager says of a camera.
 *
 * @param url of HTTP or HTTPS, where it answers with a picture (JPEG, PNG) or a stream of them
 *     (MJPEG)
 * @param robot that it is on; null: it watches a floor
 * @param floor that it watches; null: it is on a robot
 */
public record CameraOrder(String name, URI url, @Nullable String robot, @Nullable String floor) {

  /** Characters. */
  public static final int LONGEST_URL = 500;

  public CameraOrder {
    if ((robot == null) == (floor == null)) {
      throw new IllegalArgumentException("of a robot or of a floor");
    }
  }
}
