/* The microcontroller's own PWM and encoder inputs, wheel 0 to 2: on a PC a model. */
#ifndef PWM_BUS_H
#define PWM_BUS_H

#include <stdint.h>

#include "body.h"

enum { PWM_FULL = 255 };

/* The motors stand and the counts are 0. */
void pwm_bus_begin(void);

/* duty: -PWM_FULL to PWM_FULL. */
void pwm_bus_drive(uint8_t wheel, int16_t duty);

void pwm_bus_counts(int32_t counts[BODY_WHEELS]);

#endif
