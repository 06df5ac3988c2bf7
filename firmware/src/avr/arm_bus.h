/*
 * The arm's servos and sensors. Timer 3 makes a pulse every 5 ms, by itself; a multiplexer leads it to
 * one servo after the other, and that joint's potentiometer, or the load sensor, to the ADC. It is
 * switched between two pulses.
 */
#ifndef ARM_BUS_H
#define ARM_BUS_H

#include "arm.h"

void arm_bus_begin(void);

/* Every millisecond: never waits. */
void arm_bus_step(struct arm *arm);

#endif
