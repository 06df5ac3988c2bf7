package org.toqa.agent.access;

/** What the other end of a connection is, which decides what it may send. */
public enum PeerRole {
  /** The link is not encrypted: every peer is trusted. */
  ANONYMOUS,
  /** The paired server. */
  SERVER,
  /** The leader that the server has named. */
  LEADER,
  /** Was trusted once, and is not any more. */
  UNTRUSTED
}
