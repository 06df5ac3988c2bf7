/** MQTT: the embedded broker with its users and rights, and the server's own connection to one. */
@NullMarked
package org.toqa.telemetry.mqtt;

import org.jspecify.annotations.NullMarked;
