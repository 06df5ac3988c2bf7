package org.toqa.app.server;

import java.nio.file.Path;

/** The unpacked web application that this process runs from. */
public final class WebappFolder {
  private WebappFolder() {}

  public static Path path() {
    String folder = System.getProperty("toqa.webapp");
    if (folder == null) {
      throw new IllegalStateException("This starts by ./toqa, or by java -jar toqa.war.");
    }
    return Path.of(folder);
  }

  /** The map that is used where none is named. */
  public static Path shippedMap() {
    return path().resolve("WEB-INF/maps/lab.yaml");
  }
}
