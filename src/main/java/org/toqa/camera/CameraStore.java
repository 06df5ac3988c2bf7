package org.toqa.camera;

import java.util.List;

/** Where cameras are kept; each change is in the history, with who made it. */
public interface CameraStore {

  /** By their names. */
  List<Camera> cameras();

  /**
   * @param by a user's name
   * @throws org.toqa.persistence.StoreException also where another camera has the name meanwhile
   */
  Camera add(CameraOrder order, String by);

  /**
   * @param by a user's name
   * @return false: there is no such camera any more
   * @throws org.toqa.persistence.StoreException also where another camera has the name meanwhile
   */
  boolean change(Camera camera, String by);

  /**
   * @return false: there is no such camera any more
   */
  boolean delete(long id, String by);
}
