package org.toqa.app.server;

import java.io.File;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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
   * All shipped maps, as the configuration names them: a building of three floors and a workshop.
   *
   * @throws IllegalStateException as {@link #path} does
   */
  public static String shippedMaps() {
    return Stream.of("lab", "offices", "store", "workshop")
        .map(name -> path().resolve("WEB-INF/maps/" + name + ".yaml").toString())
        .collect(Collectors.joining(File.pathSeparator));
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
