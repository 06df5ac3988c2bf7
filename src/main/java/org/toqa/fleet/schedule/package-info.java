/** Tasks that come by the calendar: schedules, their recurrence, and who submits what is due. */
@NullMarked
package org.toqa.fleet.schedule;

import org.jspecify.annotations.NullMarked;
