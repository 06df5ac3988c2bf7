package org.toqa.app.server;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.apache.catalina.LifecycleException;
import org.apache.catalina.connector.Connector;
import org.apache.catalina.core.StandardContext;
import org.apache.catalina.core.StandardHost;
import org.apache.catalina.loader.WebappLoader;
import org.apache.catalina.startup.Tomcat;
import org.apache.catalina.valves.RemoteIpValve;
import org.apache.tomcat.util.net.SSLHostConfig;
import org.apache.tomcat.util.net.SSLHostConfigCertificate;
import org.apache.tomcat.util.scan.StandardJarScanFilter;
import org.apache.tomcat.util.scan.StandardJarScanner;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.Configuration;
import org.toqa.web.Sites;

/**
 * The embedded Tomcat with the one web application.
 *
 * <ol>
 *   <li>{@link #bind} takes the port, so that a second server fails before it touches anything.
 *   <li>{@link #open} lets requests in, until {@link RunningWebapp#close} lets no more in.
 *   <li>{@link #close} gives the port back.
 * </ol>
 *
 * The thread that bound it calls the rest.
 */
final class WebServer implements AutoCloseable {
  /** How long a connection may be silent, milliseconds. */
  private static final int CONNECTION_TIMEOUT_MS = 20_000;

  private final Tomcat tomcat;
  private final StandardContext context;
  private final InetAddress address;

  private WebServer(Tomcat tomcat, StandardContext context, InetAddress address) {
    this.tomcat = tomcat;
    this.context = context;
    this.address = address;
  }

  /**
   * @param webapp the unpacked web application
   * @throws IOException the port is taken, or the certificate cannot be used; the message says why,
   *     for a person
   */
  static WebServer bind(Path webapp, Configuration configuration) throws IOException {
    InetAddress address = configuration.address();
    int port = configuration.port();
    Tomcat tomcat = new Tomcat();
    tomcat.setBaseDir(Files.createDirectories(configuration.data().resolve("tomcat")).toString());
    tomcat.setConnector(connector(address, port, configuration));
    answerUnreadableRequests(tomcat);
    trustProxy(tomcat, configuration.proxy());
    WebServer server = new WebServer(tomcat, context(tomcat, webapp), address);
    try {
      tomcat.init();
      return server;
    } catch (LifecycleException e) {
      server.close();
      throw new IOException(startFailureMessage(e, configuration), e);
    }
  }

  private static Connector connector(InetAddress address, int port, Configuration configuration)
      throws IOException {
    Connector connector =
        new Connector(LimitedHttpProtocol.of(configuration.limits(), configuration.proxy()));
    connector.setPort(port);
    connector.setProperty("address", address.getHostAddress());
    connector.setProperty("useVirtualThreads", "true");
    connector.setProperty("connectionTimeout", String.valueOf(CONNECTION_TIMEOUT_MS));
    connector.setThrowOnFailure(true);
    connector.setXpoweredBy(false);
    Configuration.TlsFiles tls = configuration.tls();
    if (tls != null) {
      CertificateWithKey.read("tls", tls.certificate(), tls.key());
      enableTls(connector, tls);
    }
    return connector;
  }

  private static void enableTls(Connector connector, Configuration.TlsFiles tls) {
    SSLHostConfig host = new SSLHostConfig();
    host.setProtocols("TLSv1.2+TLSv1.3");
    SSLHostConfigCertificate certificate =
        new SSLHostConfigCertificate(host, SSLHostConfigCertificate.Type.UNDEFINED);
    certificate.setCertificateFile(tls.certificate().toString());
    certificate.setCertificateKeyFile(tls.key().toString());
    host.addCertificate(certificate);
    connector.addSslHostConfig(host);
    connector.setProperty("SSLEnabled", "true");
    connector.setScheme("https");
    connector.setSecure(true);
  }

  private static void answerUnreadableRequests(Tomcat tomcat) {
    StandardHost host = (StandardHost) tomcat.getHost();
    UnreadableRequestValve valve = new UnreadableRequestValve();
    host.getPipeline().addValve(valve);
    host.setErrorReportValveClass(valve.getClass().getName());
  }

  /** Takes the caller's address, and whether its connection is encrypted, from the proxy. */
  private static void trustProxy(Tomcat tomcat, @Nullable InetAddress proxy) {
    if (proxy != null) {
      RemoteIpValve valve = new RemoteIpValve();
      valve.setInternalProxies(Pattern.quote(proxy.getHostAddress()));
      valve.setProtocolHeader("X-Forwarded-Proto");
      tomcat.getHost().getPipeline().addValve(valve);
    }
  }

  private static StandardContext context(Tomcat tomcat, Path webapp) {
    StandardContext context = (StandardContext) tomcat.addWebapp("", webapp.toString());
    context.setParentClassLoader(WebServer.class.getClassLoader());
    // The parent has the application's classes already: load each of them once.
    WebappLoader loader = new WebappLoader();
    loader.setDelegate(true);
    context.setLoader(loader);
    // What would leak when only the application ends; here the process ends with it.
    context.setClearReferencesThreadLocals(false);
    context.setClearReferencesRmiTargets(false);
    context.setJarScanner(tagLibraryScanner());
    return context;
  }

  /** Looks for tag libraries where they are, not in every library: this halves the start. */
  private static StandardJarScanner tagLibraryScanner() {
    StandardJarScanFilter filter = new StandardJarScanFilter();
    filter.setDefaultTldScan(false);
    filter.setDefaultPluggabilityScan(false);
    filter.setTldScan("jakarta.servlet.jsp.jstl-*.jar");
    StandardJarScanner scanner = new StandardJarScanner();
    scanner.setJarScanFilter(filter);
    scanner.setScanClassPath(false);
    scanner.setScanManifest(false);
    return scanner;
  }

  private static String startFailureMessage(LifecycleException e, Configuration configuration) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof BindException) {
        return "Port "
            + configuration.port()
            + " on "
            + configuration.address().getHostAddress()
            + " cannot be had ("
            + cause.getMessage()
            + "); another program may use it: choose another one by --port.";
      }
    }
    return "The web server cannot start: " + e.getMessage();
  }

  /**
   * Lets requests in, for this server.
   *
   * @throws IOException the web application cannot start
   */
  RunningWebapp open(Sites sites) throws IOException {
    context.getServletContext().setAttribute(Sites.ATTRIBUTE, sites);
    try {
      tomcat.start();
    } catch (LifecycleException e) {
      throw new IOException("The web server cannot start: " + e.getMessage(), e);
    }
    RunningWebapp site = new RunningWebapp();
    if (!context.getState().isAvailable()) {
      site.close();
      throw new IOException("The web application cannot start; the log above says why.");
    }
    return site;
  }

  @Override
  public void close() throws IOException {
    try {
      tomcat.destroy();
    } catch (LifecycleException e) {
      throw new IOException("The web server did not end cleanly: " + e.getMessage(), e);
    }
  }

  /** The web application while requests reach it. */
  final class RunningWebapp implements AutoCloseable {
    private RunningWebapp() {}

    /** Where a browser finds it. */
    URI uri() {
      String host = address.isAnyLocalAddress() ? "localhost" : address.getHostAddress();
      return URI.create(
          tomcat.getConnector().getScheme()
              + "://"
              + (host.contains(":") ? "[" + host + "]" : host)
              + ":"
              + tomcat.getConnector().getLocalPort()
              + "/");
    }

    @Override
    public void close() throws IOException {
      try {
        tomcat.stop();
      } catch (LifecycleException e) {
        throw new IOException("The web server did not end cleanly: " + e.getMessage(), e);
      }
    }
  }
}
