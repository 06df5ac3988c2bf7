/** What tests stand on: processes, a stock Tomcat, a real MySQL server, a browser. */
@NullMarked
package org.toqa.testbed;

import org.jspecify.annotations.NullMarked;
