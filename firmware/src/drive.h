/*
 * What turns three wheels. One drive is linked into a program: the LM629 controllers (lm629.c) or
 * the microcontroller's own PWM and encoders (pwm_drive.c).
 *
 *   1. drive_begin: the wheels are stopped, the counts are 0.
 *   2. every 10 ms: drive_read_counts, then drive_turn.
 *   3. while the wheels shall stop, drive_stop at once and every millisecond instead of drive_turn,
 *      and drive_rest when they have not turned for 10 ms.
 *
 * Each returns false when the hardware does not answer or reports an error.
 */
#ifndef DRIVE_H
#define DRIVE_H

#include <stdbool.h>
#include <stdint.h>

#include "body.h"
#include "wheel.h"

enum { DRIVE_PERIOD_MS = 10 };

bool drive_begin(void);
bool drive_read_counts(int32_t counts[BODY_WHEELS]);
bool drive_turn(const struct wheel_rates *rates);

/* Brakes as hard as the motors can. */
bool drive_stop(void);

/* Switches off wheels that are stopped: they push no longer against what blocks them. */
bool drive_rest(void);

#endif
