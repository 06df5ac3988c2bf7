package org.toqa.web.input;

import java.net.URI;
import java.net.URISyntaxException;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.toqa.camera.Camera;
import org.toqa.camera.CameraOrder;
import org.toqa.camera.Cameras;
import org.toqa.web.CameraList;

/**
 * Reads what a manager says of a camera: its {@code name}, its {@code url}, and the {@code robot}
 * it is on or the {@code floor} that it watches.
 */
public final class CameraReader {
  private static final String NAME = "name";
  private static final String URL = "url";
  private static final String ROBOT = "robot";
  private static final String FLOOR = "floor";
  private static final int MAX_PORT = 65_535;

  private final Fields fields;

  private CameraReader(Fields fields) {
    this.fields = fields;
  }

  /** A new one; it means something only when no error was filed. */
  public static CameraOrder read(Fields fields, CameraList cameras) {
    List<Camera> others = cameras.all();
    CameraReader reader = new CameraReader(fields);
    if (others.size() >= Cameras.MOST) {
      reader.refuse(NAME, "error.camera.many", Cameras.MOST);
    }
    return reader.order(others, cameras);
  }

  /**
   * What an existing one is changed to; it means something only when no error was filed.
   *
   * @param id of that one
   */
  public static Camera read(Fields fields, CameraList cameras, long id) {
    List<Camera> others = cameras.all().stream().filter(camera -> camera.id() != id).toList();
    return new Camera(id, new CameraReader(fields).order(others, cameras));
  }

  private CameraOrder order(List<Camera> others, CameraList cameras) {
    String name = fields.rules().deviceName(NAME, fields.text(NAME));
    if (others.stream().anyMatch(camera -> camera.name().equals(name))) {
      refuse(NAME, "error.camera.name", name);
    }
    URI url = url();
    String robot = known(ROBOT, cameras.robots(), "error.camera.robot");
    String floor = known(FLOOR, cameras.floors(), "error.camera.floor");
    if ((robot == null) == (floor == null)) {
      refuse(ROBOT, "error.camera.place");
      robot = name;
      floor = null;
    }
    fields.refuseUnknown();
    return new CameraOrder(name, url, robot, floor);
  }

  private @Nullable String known(String field, List<String> names, String key) {
    String given = fields.text(field);
    if (given != null && !names.contains(given)) {
      refuse(field, key);
    }
    return given;
  }

  private URI url() {
    String given = fields.text(URL);
    URI url = given == null ? null : parsed(given.strip());
    if (url == null) {
      refuse(URL, "error.camera.url", CameraOrder.LONGEST_URL);
      return URI.create("http://camera");
    }
    return url;
  }

  /** Null: it is no address of HTTP with a host. */
  private static @Nullable URI parsed(String given) {
    try {
      URI url = new URI(given);
      String scheme = url.getScheme() == null ? "" : url.getScheme().toLowerCase(Locale.ROOT);
      boolean isRight =
          (scheme.equals("https") || scheme.equals("http"))
              && given.length() <= CameraOrder.LONGEST_URL
              && given.chars().allMatch(c -> c > ' ' && c < 127)
              && url.getHost() != null
              && url.getFragment() == null
              && url.getPort() != 0
              && url.getPort() <= MAX_PORT;
      return isRight ? url : null;
    } catch (URISyntaxException e) {
      return null;
    }
  }

  private void refuse(String field, String key, Object... values) {
    fields.errors().add(fields.path(field), fields.texts().get(key, values));
  }
}
