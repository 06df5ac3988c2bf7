package org.toqa.launch;

/** Starts the executable WAR. */
public final class Launcher {
  private Launcher() {}

  public static void main(String[] args) {}
}
