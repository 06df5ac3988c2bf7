package org.toqa.app.server;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.FilterRegistration;
import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletContextEvent;
import jakarta.servlet.ServletContextListener;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.web.Sites;

/**
 * Starts and stops the server with its web application on a stock Tomcat, configured by the
 * environment and by the file that {@code TOQA_CONFIG}, the system property or the context
 * parameter {@code toqa.config} names. Does nothing where a command has started the server already.
 */
public final class ToqaContextListener implements ServletContextListener {

  private static final String FILE_PROPERTY = "toqa.config";

  private @Nullable SiteServers ownSites;

  /**
   * @throws IllegalStateException the server cannot start; the message says why
   */
  @Override
  public void contextInitialized(ServletContextEvent event) {
    ServletContext context = event.getServletContext();
    if (context.getAttribute(Sites.ATTRIBUTE) != null) {
      return;
    }
    try {
      Configuration configuration = configuration(context);
      Logging.configure(configuration.logLevel(), configuration.logFormat());
      ownSites = SiteServers.start(configuration);
      context.setAttribute(Sites.ATTRIBUTE, ownSites);
      trustProxy(context, configuration.proxy());
    } catch (ConfigurationException | IOException e) {
      // The container shows the message in its log, and does not serve the application.
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  @Override
  public void contextDestroyed(ServletContextEvent event) {
    if (ownSites != null) {
      event.getServletContext().removeAttribute(Sites.ATTRIBUTE);
      ownSites.close();
      ownSites = null;
    }
  }

  /**
   * Takes the caller's address, and whether its connection is encrypted, from the proxy. Tomcat's
   * own filter does it: it comes before all others, and is named, since this class loads without
   * it.
   */
  private static void trustProxy(ServletContext context, @Nullable InetAddress proxy) {
    if (proxy != null) {
      FilterRegistration.Dynamic filter =
          context.addFilter("proxy", "org.apache.catalina.filters.RemoteIpFilter");
      filter.setInitParameter("internalProxies", Pattern.quote(proxy.getHostAddress()));
      filter.setInitParameter("protocolHeader", "X-Forwarded-Proto");
      filter.setAsyncSupported(true);
      filter.addMappingForUrlPatterns(EnumSet.of(DispatcherType.REQUEST), false, "/*");
    }
  }

  private static Configuration configuration(ServletContext context) throws ConfigurationException {
    String folder = context.getRealPath("/");
    if (folder == null) {
      throw new ConfigurationException(
          "The web application must be unpacked: set unpackWARs=\"true\" in server.xml.");
    }
    List<SettingSource> layers = new ArrayList<>();
    layers.add(SettingSource.fromEnvironment(System.getenv()));
    String file = configurationFile(context);
    if (file != null) {
      layers.add(SettingSource.fromFile(Path.of(file)));
    }
    layers.add(tomcatDefaults());
    return Configuration.of(WebappFolder.shippedMap(Path.of(folder)), layers);
  }

  private static @Nullable String configurationFile(ServletContext context) {
    return Stream.of(
            System.getenv().getOrDefault(SettingSource.FILE_ENVIRONMENT_VARIABLE, ""),
            System.getProperty(FILE_PROPERTY, ""),
            String.valueOf(context.getInitParameter(FILE_PROPERTY)))
        .filter(name -> !name.isEmpty() && !name.equals("null"))
        .findFirst()
        .orElse(null);
  }

  /** The folder from which Tomcat was started may be any; its own folder is known. */
  private static SettingSource tomcatDefaults() {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    String tomcat = System.getProperty("catalina.base");
    options.put(Setting.DATA, tomcat == null ? null : Path.of(tomcat, "toqa-data").toString());
    return SettingSource.fromCommandLine(options);
  }
}
