/** Routes in space and time: what a robot can do, when the floor is free, the quickest route. */
@NullMarked
package org.toqa.traffic.route;

import org.jspecify.annotations.NullMarked;
