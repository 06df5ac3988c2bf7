/** A body whose two wheels are told their speeds over HTTP ({@code docs/http-robot.md}). */
@NullMarked
package org.toqa.agent.http;

import org.jspecify.annotations.NullMarked;
