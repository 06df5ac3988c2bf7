package org.toqa.agent.config;

/** A configuration that cannot be used; the message is one line for the person who wrote it. */
public final class ConfigException extends Exception {
  private static final long serialVersionUID = 1;

  ConfigException(String line) {
    super(line);
  }
}
