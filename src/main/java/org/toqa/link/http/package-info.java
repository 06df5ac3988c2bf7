/**
 * Robots that take the speeds of their two wheels over HTTP ({@code docs/http-robot.md}): the
 * messages as both ends use them, and the server's client.
 */
@NullMarked
package org.toqa.link.http;

import org.jspecify.annotations.NullMarked;
