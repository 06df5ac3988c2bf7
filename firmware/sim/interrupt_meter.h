/* How long the chip's interrupt routines take; lets the chip's time pass where simavr does not. */
#ifndef INTERRUPT_METER_H
#define INTERRUPT_METER_H

#include <simavr/sim_avr.h>
#include <stdbool.h>

enum { INTERRUPT_METER_VECTORS = 35 };

void interrupt_meter_begin(avr_t *avr);

/* After every reset of the chip, which ends what ran. */
void interrupt_meter_restart(void);

bool interrupt_meter_runs(uint8_t vector);

/*
 * The most cycles from an interrupt's beginning to its return, without those of others that
 * interrupted it; 0 for one that never came.
 */
uint32_t interrupt_meter_longest(uint8_t vector);

#endif
