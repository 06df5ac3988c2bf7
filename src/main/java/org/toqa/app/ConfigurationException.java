package org.toqa.app;

/** A configuration that cannot be used; the message names the place, the value and the remedy. */
public final class ConfigurationException extends Exception {
  private static final long serialVersionUID = 1;

  private final String sentence;

  ConfigurationException(String sentence) {
    super(sentence);
    this.sentence = sentence;
  }

  @Override
  public String getMessage() {
    return sentence;
  }
}
