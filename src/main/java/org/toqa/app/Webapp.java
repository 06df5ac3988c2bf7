package org.toqa.app;

import java.nio.file.Path;

/** The unpacked web application that this process runs from. */
final class Webapp {
  private Webapp() {}

  static Path folder() {
    String folder = System.getProperty("toqa.webapp");
    if (folder == null) {
      throw new IllegalStateException("This starts by ./toqa, or by java -jar toqa.war.");
    }
    return Path.of(folder);
  }

  /** The map that is used where none is named. */
  static Path shippedMap() {
    return folder().resolve("WEB-INF/maps/lab.yaml");
  }
}
