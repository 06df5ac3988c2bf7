package org.toqa.app.bench;

import java.util.UUID;

/** The manager as whom a bench uses the pages and the API of a server of its own. */
record BenchUser(String name, String password) {

  /** With a password that nobody can guess. */
  static BenchUser create() {
    return new BenchUser("bench", UUID.randomUUID().toString());
  }

  /** As {@link org.toqa.app.config.Setting#MANAGER} takes it. */
  String setting() {
    return name + ":" + password;
  }

  @Override
  public String toString() {
    return "BenchUser[" + name + "]";
  }
}
