package org.toqa.network;

import java.util.Arrays;
import java.util.Optional;

/** What a device of the network is. */
public enum DeviceKind {
  ROBOT("robot"),
  CAMERA("camera"),
  ACCESS_POINT("access-point"),
  OTHER("other");

  private final String word;

  DeviceKind(String word) {
    this.word = word;
  }

  /** As forms and the API have it. */
  public String word() {
    return word;
  }

  public static Optional<DeviceKind> ofWord(String word) {
    return Arrays.stream(values()).filter(kind -> kind.word.equals(word)).findFirst();
  }
}
