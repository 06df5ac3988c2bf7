/** A robot that takes wheel commands over HTTP, with a simulated body: a program of its own. */
@NullMarked
package org.toqa.app.robot;

import org.jspecify.annotations.NullMarked;
