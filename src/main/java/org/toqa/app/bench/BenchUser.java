package org.toqa.app.bench;

import java.util.EnumMap;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.OptionalMapOption;
import org.toqa.app.config.Setting;

/** The manager as whom a bench uses the pages and the API of a server of its own. */
record BenchUser(String name, String password) {

  /** With a password that nobody can guess. */
  static BenchUser create() {
    return new BenchUser("bench", UUID.randomUUID().toString());
  }

  /** As {@link Setting#MANAGER} takes it. */
  String setting() {
    return name + ":" + password;
  }

  /** Of a server that this user manages. */
  Map<Setting, @Nullable String> settings(int robots, OptionalMapOption map) {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.SIMULATE, String.valueOf(robots));
    settings.put(Setting.MAP, map.file());
    settings.put(Setting.MANAGER, setting());
    return settings;
  }

  @Override
  public String toString() {
    return "BenchUser[" + name + "]";
  }
}
