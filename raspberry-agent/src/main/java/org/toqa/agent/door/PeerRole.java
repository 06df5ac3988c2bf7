package org.toqa.agent.door;

/** As what the other end of a connection may speak. */
public enum PeerRole {
  /** The link is not encrypted: whoever speaks is believed. */
  ANYBODY,
  /** The paired server. */
  SERVER,
  /** The leader that the server has named. */
  LEADER,
  /** Was trusted once, and is not any more. */
  NOBODY
}
