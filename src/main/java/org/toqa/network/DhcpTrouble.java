package org.toqa.network;

/**
 * What keeps this server from configuring or reading the DHCP server.
 *
 * @param what the file or the process that it is about
 */
public record DhcpTrouble(Kind kind, String what) {
  /** What it is, and so what to do. */
  public enum Kind {
    HOSTS_NOT_WRITTEN,
    LEASES_NOT_READ,
    NOT_RUNNING,
    NOT_TOLD
  }
}
