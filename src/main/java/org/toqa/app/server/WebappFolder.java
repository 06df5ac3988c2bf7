package org.toqa.app.server;

import java.nio.file.Path;

/** The unpacked web application that this process runs from. */
public final class WebappFolder {
  private WebappFolder() {}

  /**
   * @throws IllegalStateException the process was not started by the launcher; says how to
   */
  public static Path path() {
    String folder = System.getProperty("toqa.webapp");
    if (folder == null) {
      throw new IllegalStateException("This starts by ./toqa, or by java -jar toqa.war.");
    }
    return Path.of(folder);
  }

  /**
   * The map that is used where none is named.
   *
   * @throws IllegalStateException as {@link #path} does
   */
  public static Path shippedMap() {
    return shippedMap(path());
  }

  /**
   * The map that is used where none is named.
   *
   * @param webapp the folder of an unpacked web application
   */
  static Path shippedMap(Path webapp) {
    return webapp.resolve("WEB-INF/maps/lab.yaml");
  }
}
