package org.toqa.app.config;

/** A configuration that cannot be used; the message names the place, the value and the remedy. */
public final class ConfigurationException extends Exception {
  private static final long serialVersionUID = 1;

  private final String message;

  public ConfigurationException(String message) {
    super(message);
    this.message = message;
  }

  @Override
  public String getMessage() {
    return message;
  }
}
