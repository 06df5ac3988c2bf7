/*
 * Kinematics of three omnidirectional wheels, 120 degrees apart; wheel 2's axle lies on the x axis
 * (Tanta, "Kinematics of the three-wheeled omni robot"):
 *
 *   v1 =  sqrt(3)/2 vx - 1/2 vy + R w
 *   v2 =                     vy + R w
 *   v3 = -sqrt(3)/2 vx - 1/2 vy + R w
 *
 * A wheel rate is in counts a second times 2^8. Rates are off by at most 1 of these units, 0.4 um/s
 * at the rim, plus 2e-7 of their value.
 */
#ifndef WHEEL_H
#define WHEEL_H

#include <stdint.h>

#include "body.h"
#include "settings.h"
#include "twist.h"

/* 220 turns a minute. */
#define WHEEL_RATED_Q8 ((int32_t)BODY_COUNTS_PER_TURN * 256 * BODY_RATED_RPM / 60)

/* 150 turns a minute. */
#define WHEEL_MAX_RATE_Q8 ((int32_t)BODY_COUNTS_PER_TURN * 256 * BODY_MAX_RPM / 60)

/* Of a robot's wheels; all times 2^24. */
struct wheel_scale {
    int32_t aside;   /* rate of a wheel whose rim moves at 1 um/s */
    int32_t along;   /* sqrt(3)/2 of that */
    int32_t turning; /* of a body that turns at 1 urad/s */
};

struct wheel_rates {
    int32_t q8[BODY_WHEELS]; /* counts a second times 2^8 */
};

struct wheel_scale wheel_scale_of(const struct settings *settings);

void wheel_rates_from_twist(const struct wheel_scale *scale, const struct twist *twist,
                            struct wheel_rates *rates);

/* Slows all wheels alike until none is commanded to turn too fast: the curve stays. */
void wheel_rates_limit(struct wheel_rates *rates);

#endif
