/** The whole road of a task, on the product as it is packaged: processes, sockets, databases. */
@NullMarked
package org.toqa.road;

import org.jspecify.annotations.NullMarked;
