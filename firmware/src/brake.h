/*
 * When a motor that is reversed to brake has stopped its wheel: known from the distance, without
 * knowing the load. Reversed with a voltage that alone would make a rate of -V, the wheel slows down
 * from r0 by dr/dt = -(V + r)/T, where T grows with the load. When r is 0, the distance covered is
 *
 *   r0 t (1/s - V/r0)   with s = ln(1 + r0/V)
 *
 * whatever T is; the bracket is 1/2 - 0.066 r0/V within 0.5 %.
 */
#ifndef BRAKE_H
#define BRAKE_H

#include <stdbool.h>
#include <stdint.h>

#include "body.h"

struct brake {
    int32_t from[BODY_WHEELS];      /* counts */
    int32_t rate_q12[BODY_WHEELS];  /* r0, counts a millisecond times 2^12, without sign */
    int32_t share_q8[BODY_WHEELS];  /* the bracket, times 2^8 */
    bool is_backward[BODY_WHEELS];
};

/* Nobody reverses a wheel for longer: twice what a robot needs that carries its own mass. */
enum { BRAKE_MAX_MS_Q4 = 150 * 16 };

/* counts: now; rate: that it turns with, counts a second; voltage: V or -V, counts a second. */
void brake_begin_reversing(struct brake *brake, uint8_t wheel, int32_t counts, int32_t rate,
                   int32_t voltage);

/* Returns whether the wheel is stopped now. ms_q4: since it was reversed, times 2^4. */
bool brake_has_stopped(const struct brake *brake, uint8_t wheel, int32_t counts, uint16_t ms_q4);

/* When the wheel will have stopped, as estimated now: the nearer the end, the better it is known. */
uint16_t brake_end_ms_q4(const struct brake *brake, uint8_t wheel, int32_t counts, uint16_t ms_q4);

#endif
