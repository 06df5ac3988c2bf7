/**
 * Addresses of robots, cameras and access points: which device has which, what the DHCP server is
 * told of it and tells, and who can be reached.
 */
@NullMarked
package org.toqa.network;

import org.jspecify.annotations.NullMarked;
