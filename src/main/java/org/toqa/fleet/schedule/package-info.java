/**
 * Tasks that come by the calendar: changes of schedules, and what submits the tasks that are due.
 */
@NullMarked
package org.toqa.fleet.schedule;

import org.jspecify.annotations.NullMarked;
