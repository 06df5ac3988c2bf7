/* How much the chip's program has to do, from its first sleep on; each is told once. */
#ifndef LOAD_METER_H
#define LOAD_METER_H

#include <simavr/sim_avr.h>

enum { LOAD_METER_PERIOD_US = 10000 };

void load_meter_restart(void);

/* After every step of the chip that began then, and in that state. */
void load_meter_step(const avr_t *avr, avr_cycle_count_t begun, int state);

/* The most microseconds of a period in which it did not sleep. */
uint32_t load_meter_take_busiest_us(void);

/* The most microseconds without any sleep: so long waits what comes meanwhile. */
uint32_t load_meter_take_longest_us(void);

#endif
