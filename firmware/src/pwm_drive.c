/*
 * A drive without motion controllers: the motor's voltage fed forward in proportion to the rate,
 * and more or less of it in proportion to the error of a position that moves on with the rate.
 */
#include <string.h>

#include "drive.h"
#include "pwm_bus.h"

/* PWM steps a count, times 2^8: with 0.35 the wheel follows with a time constant of 70 ms. */
static const int32_t GAIN_Q8 = 90;

/* PWM steps for a count a period, times 2^8, that brake. */
static const int32_t BRAKING_Q8 = 2L * 256 * PWM_FULL * 1000 / DRIVE_PERIOD_MS /
                                  (WHEEL_RATED_Q8 / 256);

/* A blocked wheel's wanted position runs away no further than what full voltage answers. */
static const int32_t MOST_ERROR_Q8 = INT32_C(728) * 256;

static int32_t wanted[BODY_WHEELS];   /* counts */
static int32_t wanted_q8[BODY_WHEELS]; /* and the part of a count beyond it, times 2^8 */
static int32_t counts_now[BODY_WHEELS];
static int32_t moved[BODY_WHEELS]; /* counts in the last period */

bool drive_begin(void)
{
    pwm_bus_begin();
    memset(wanted, 0, sizeof wanted);
    memset(wanted_q8, 0, sizeof wanted_q8);
    memset(counts_now, 0, sizeof counts_now);
    memset(moved, 0, sizeof moved);
    return true;
}

bool drive_read_counts(int32_t counts[BODY_WHEELS])
{
    pwm_bus_counts(counts);
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        moved[wheel] = counts[wheel] - counts_now[wheel];
        counts_now[wheel] = counts[wheel];
    }
    return true;
}

static int32_t clamped(int32_t value, int32_t limit)
{
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : value;
}

static int32_t advanced_error_q8(uint8_t wheel, int32_t rate_q8)
{
    int32_t moved_q8 = wanted_q8[wheel] + rate_q8 * DRIVE_PERIOD_MS / 1000;
    int32_t error_q8;

    wanted[wheel] += moved_q8 / 256;
    wanted_q8[wheel] = moved_q8 % 256;
    error_q8 = clamped((wanted[wheel] - counts_now[wheel]) * 256 + wanted_q8[wheel], MOST_ERROR_Q8);
    wanted[wheel] = counts_now[wheel] + (error_q8 - wanted_q8[wheel]) / 256;
    return error_q8;
}

bool drive_turn(const struct wheel_rates *rates)
{
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        int32_t forward = (int32_t)((int64_t)rates->q8[wheel] * PWM_FULL / WHEEL_RATED_Q8);
        int32_t more = (advanced_error_q8(wheel, rates->q8[wheel]) * GAIN_Q8) / 65536;

        pwm_bus_drive(wheel, (int16_t)clamped(forward + more, PWM_FULL));
    }
    return true;
}

/* Against the motion, twice as strongly as what would keep it up. */
bool drive_stop(void)
{
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        int32_t against = -moved[wheel] * BRAKING_Q8 / 256;

        wanted[wheel] = counts_now[wheel];
        wanted_q8[wheel] = 0;
        pwm_bus_drive(wheel, (int16_t)clamped(against, PWM_FULL));
    }
    return true;
}

bool drive_hold(void)
{
    return drive_stop();
}
