/**
 * The whole road of a task, over a real server and a real daemon: pages, sockets, database, wheels.
 */
@NullMarked
package org.toqa.road;

import org.jspecify.annotations.NullMarked;
