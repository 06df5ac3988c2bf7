package org.toqa.grid;

import java.io.IOException;

/** A map file that cannot be used; the message names the file, the place in it and the remedy. */
public final class MapFormatException extends IOException {
  public MapFormatException(String message) {
    super(message);
  }

  public MapFormatException(String message, Throwable cause) {
    super(message, cause);
  }
}
