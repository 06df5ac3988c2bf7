package org.toqa.agent.access;

/** As what the other end of a connection may speak. */
public enum PeerRole {
  /** The link is not encrypted: whoever speaks is believed. */
  ANONYMOUS,
  /** The paired server. */
  SERVER,
  /** The leader that the server has named. */
  LEADER,
  /** Was trusted once, and is not any more. */
  UNTRUSTED
}
