/** What a robot does now, and what it reports of it. */
@NullMarked
package org.toqa.agent.control;

import org.jspecify.annotations.NullMarked;
