/**
 * Links to robots that the server cannot reach: a gateway beside them dials out to the server and
 * carries their bytes, unopened. Both its ends: the server's ({@code GatewayPort}) and the
 * gateway's own ({@code GatewayAgent}).
 */
@NullMarked
package org.toqa.link.gateway;

import org.jspecify.annotations.NullMarked;
