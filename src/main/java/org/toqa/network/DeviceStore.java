package org.toqa.network;

import java.util.List;

/** Where devices are kept; each change is in the history, with who made it. */
public interface DeviceStore {

  /** By their names. */
  List<Device> devices();

  /**
   * @param by a user's name
   * @throws org.toqa.persistence.StoreException also where another device has the name or an
   *     address meanwhile
   */
  Device add(DeviceOrder order, String by);

  /**
   * @return false: there is no such device any more
   */
  boolean change(long id, DeviceOrder order, String by);

  /**
   * @return false: there is no such device any more
   */
  boolean delete(long id, String by);
}
