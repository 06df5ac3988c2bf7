/* The microcontroller's own PWM and encoder inputs, wheel 0 to 2: on a PC a model. */
#ifndef PWM_BUS_H
#define PWM_BUS_H

#include <stdint.h>

#include "body.h"

enum { PWM_FULL = 255, PWM_BUS_MOVED_MS = 20 };

/* The motors are stopped and the counts are 0. */
void pwm_bus_begin(void);

/* duty: -PWM_FULL to PWM_FULL. */
void pwm_bus_drive(uint8_t wheel, int16_t duty);

/* Begins to count time, in milliseconds times 2^4, up to 255 ms. */
void pwm_bus_begin_time(void);
uint16_t pwm_bus_ms_q4(void);

/* As pwm_bus_drive, but at this time, or a millisecond later, the duty becomes 0. */
void pwm_bus_drive_until(uint8_t wheel, int16_t duty, uint16_t ms_q4);

/* Another end for what has not ended yet. */
void pwm_bus_end_at(uint8_t wheel, uint16_t ms_q4);

/* Counts in the last PWM_BUS_MOVED_MS, however late the main loop is. */
int32_t pwm_bus_moved(uint8_t wheel);

/* To be called at least every 20 ms while wheels turn. */
void pwm_bus_counts(int32_t counts[BODY_WHEELS]);

#endif
