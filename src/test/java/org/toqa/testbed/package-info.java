/**
 * What tests are built on: processes, a stock Tomcat, a real MySQL server, a browser, networks,
 * fuzzed lines.
 */
@NullMarked
package org.toqa.testbed;

import org.jspecify.annotations.NullMarked;
