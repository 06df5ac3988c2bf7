/* The millisecond, by timer 0. */
#ifndef CLOCK_H
#define CLOCK_H

#include <stdint.h>

void clock_begin(void);

/* Milliseconds since the start, modulo 256. */
uint8_t clock_ticks(void);

#endif
