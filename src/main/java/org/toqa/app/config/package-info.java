/** The configuration: settings from files, environment and command line, checked in one place. */
@NullMarked
package org.toqa.app.config;

import org.jspecify.annotations.NullMarked;
