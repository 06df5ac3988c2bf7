package org.toqa.launch;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.net.URISyntaxException;
import java.net.URLClassLoader;
import java.nio.file.Path;

/**
 * Starts the executable WAR: unpacks it once into the user's cache, and calls {@code
 * org.toqa.app.Main} in one class loader over its classes, its libraries and the embedded server.
 * This package is compiled for an old Java, so that an old Java can say what it lacks.
 */
public final class Launcher {
  private static final int REQUIRED_JAVA = 25;

  private Launcher() {}

  public static void main(String[] args) throws Throwable {
    int present = Runtime.version().feature();
    if (present < REQUIRED_JAVA) {
      System.err.println(
          "toqa: needs Java " + REQUIRED_JAVA + " or newer; this is Java " + present + ".");
      System.exit(2);
    }
    Path cache = cacheFolder();
    try {
      run(UnpackedWar.of(warFile(), cache), args);
    } catch (IOException e) {
      System.err.println(
          "toqa: cannot unpack itself into "
              + cache
              + " ("
              + e
              + "); set XDG_CACHE_HOME to a"
              + " folder that can be written and has 100 MB free.");
      System.exit(1);
    }
  }

  private static void run(UnpackedWar war, String[] args) throws Throwable {
    URLClassLoader loader =
        new URLClassLoader("toqa", war.classPath(), ClassLoader.getPlatformClassLoader());
    Thread.currentThread().setContextClassLoader(loader);
    System.setProperty("toqa.webapp", war.folder().toString());
    try {
      Class<?> main = Class.forName("org.toqa.app.Main", true, loader);
      main.getMethod("main", String[].class).invoke(null, (Object) args);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  private static Path warFile() throws IOException {
    try {
      return Path.of(Launcher.class.getProtectionDomain().getCodeSource().getLocation().toURI())
          .toRealPath();
    } catch (URISyntaxException e) {
      throw new IOException(e);
    }
  }

  private static Path cacheFolder() {
    String xdg = System.getenv("XDG_CACHE_HOME");
    return xdg == null || xdg.isEmpty()
        ? Path.of(System.getProperty("user.home"), ".cache", "toqa")
        : Path.of(xdg, "toqa");
  }
}
