/* What either drive's bus does by the clock. */
#ifndef DRIVE_BUS_H
#define DRIVE_BUS_H

/* For the interrupt of the clock only. */
void drive_bus_on_millisecond(void);

#endif
