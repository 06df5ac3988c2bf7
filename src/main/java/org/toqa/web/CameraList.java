package org.toqa.web;

import java.util.List;
import org.toqa.camera.Camera;
import org.toqa.camera.Cameras;
import org.toqa.fleet.RobotView;
import org.toqa.grid.FloorMap;

/** The cameras of a site, with the robots and floors that they may belong to. */
public final class CameraList {
  private final Services services;

  public CameraList(Services services) {
    this.services = services;
  }

  /** By their names. */
  public List<Camera> all() {
    return cameras().all();
  }

  public Cameras cameras() {
    return services.cameras();
  }

  /** Names of those that there are. */
  public List<String> robots() {
    return services.fleet().snapshots().latest().robots().stream().map(RobotView::name).toList();
  }

  /** Names of those that there are. */
  public List<String> floors() {
    return services.fleet().floors().stream().map(FloorMap::name).toList();
  }
}
