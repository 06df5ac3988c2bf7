package org.toqa.app;

import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletContextEvent;
import jakarta.servlet.ServletContextListener;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Services;

/**
 * Begins and ends the product with its web application. Where a command has started it already, it
 * is that command's; on a stock Tomcat it is this listener's, configured by the environment and by
 * the file that {@code TOQA_CONFIG}, the system property or the context parameter {@code
 * toqa.config} names.
 */
public final class ToqaContextListener implements ServletContextListener {

  private static final String FILE = "toqa.config";

  private @Nullable Toqa owned;

  @Override
  public void contextInitialized(ServletContextEvent event) {
    ServletContext context = event.getServletContext();
    if (context.getAttribute(Services.ATTRIBUTE) != null) {
      return;
    }
    try {
      Configuration configuration = configuration(context);
      Logging.set(configuration.logLevel(), configuration.logFormat());
      owned = Toqa.start(configuration);
      context.setAttribute(Services.ATTRIBUTE, owned.services());
    } catch (ConfigurationException | IOException e) {
      // The container shows the message in its log, and does not serve the application.
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  @Override
  public void contextDestroyed(ServletContextEvent event) {
    if (owned != null) {
      event.getServletContext().removeAttribute(Services.ATTRIBUTE);
      owned.close();
      owned = null;
    }
  }

  private static Configuration configuration(ServletContext context) throws ConfigurationException {
    String folder = context.getRealPath("/");
    if (folder == null) {
      throw new ConfigurationException(
          "The web application must be unpacked: set unpackWARs=\"true\" in server.xml.");
    }
    List<Layer> layers = new ArrayList<>();
    layers.add(Layer.ofEnvironment(System.getenv()));
    String file = file(context);
    if (file != null) {
      layers.add(Layer.ofFile(Path.of(file)));
    }
    layers.add(besideTomcat());
    return Configuration.of(Path.of(folder), layers);
  }

  private static @Nullable String file(ServletContext context) {
    return Stream.of(
            System.getenv().getOrDefault(Layer.FILE_VARIABLE, ""),
            System.getProperty(FILE, ""),
            String.valueOf(context.getInitParameter(FILE)))
        .filter(name -> !name.isEmpty() && !name.equals("null"))
        .findFirst()
        .orElse(null);
  }

  /** A Tomcat's working folder is anybody's guess; its own folder is not. */
  private static Layer besideTomcat() {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    String tomcat = System.getProperty("catalina.base");
    options.put(Setting.DATA, tomcat == null ? null : Path.of(tomcat, "toqa-data").toString());
    return Layer.ofCommandLine(options);
  }
}
