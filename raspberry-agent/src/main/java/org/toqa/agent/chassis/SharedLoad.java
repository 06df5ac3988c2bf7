package org.toqa.agent.chassis;

import org.toqa.link.message.ServerMessage.CarriedPart;

/**
 * A load that lies on several robots.
 *
 * @param task for which they carry it
 * @param part that this robot has
 */
public record SharedLoad(long task, CarriedPart part) {}
