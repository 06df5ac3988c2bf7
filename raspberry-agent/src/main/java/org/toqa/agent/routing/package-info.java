/**
 * The ad hoc network: babeld, which forwards for other robots and finds ways to them (the Babel
 * routing protocol, RFC 8966), is configured, run and read here.
 */
@NullMarked
package org.toqa.agent.routing;

import org.jspecify.annotations.NullMarked;
