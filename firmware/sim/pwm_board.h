/*
 * The motors at drivers that take PWM and a direction, and their encoders at the chip's pins. The
 * duty is what timer 1 is set to; the edges of the encoders come one by one, each at its time.
 */
#ifndef PWM_BOARD_H
#define PWM_BOARD_H

#include "drive_model.h"

extern const struct drive_model pwm_board;

#endif
