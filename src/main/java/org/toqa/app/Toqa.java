package org.toqa.app;

/**
 * The product behind its web pages: store, fleet and simulated robots. It has one owner, the
 * command that started it or, on a stock Tomcat, {@link ToqaContextListener}.
 */
final class Toqa implements AutoCloseable {
  private final Configuration configuration;

  private Toqa(Configuration configuration) {
    this.configuration = configuration;
  }

  static Toqa start(Configuration configuration) {
    return new Toqa(configuration);
  }

  Configuration configuration() {
    return configuration;
  }

  @Override
  public void close() {}
}
