package org.toqa.fleet;

import org.toqa.link.trust.PairingCode;

/**
 * An order to pair a robot that is known with this server, anew or for the first time.
 *
 * @param code that the robot shows
 */
public record PairingOrder(String host, int port, PairingCode code) {}
