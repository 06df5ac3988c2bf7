/*
 * A wheel that is commanded to turn and does not: over 300 ms less than a quarter of its counts.
 * Both directions count alike, since a wheel that is reversed lags behind.
 */
#ifndef STALL_H
#define STALL_H

#include <stdbool.h>
#include <stdint.h>

#include "body.h"
#include "wheel.h"

struct stall {
    uint16_t elapsed_ms;
    uint32_t commanded_q8_ms[BODY_WHEELS]; /* counts times 2^8 times 1000, forwards and backwards */
    uint32_t counted[BODY_WHEELS];         /* counts, forwards and backwards */
    int32_t last_counts[BODY_WHEELS];      /* of the encoders at the last update */
};

void stall_begin(struct stall *stall, const int32_t counts[BODY_WHEELS]);

/* rates: what the wheels were commanded in the last ms. Returns whether one of them is stalled. */
bool stall_update(struct stall *stall, const struct wheel_rates *rates,
                 const int32_t counts[BODY_WHEELS], uint16_t ms);

#endif
