/**
 * The configuration of a daemon: its file, its chassis and its limits, checked before the start.
 */
@NullMarked
package org.toqa.agent.config;

import org.jspecify.annotations.NullMarked;
