#include "wheel.h"

/* Rate of a wheel whose rim moves at 1 um/s, times 2^24; pi = 355/113, which is off by 9e-8. */
static const int64_t RATE_Q24 =
    (INT64_C(256) * BODY_COUNTS_PER_TURN * 113 * (INT64_C(1) << 24)) /
    (INT64_C(2) * 355 * BODY_WHEEL_RADIUS_UM);

/* sqrt(3)/2 = 18817/21728, off by 2e-9. */
static const int64_t ALONG_Q24 =
    (INT64_C(256) * BODY_COUNTS_PER_TURN * 113 * (INT64_C(1) << 24)) /
    (INT64_C(2) * 355 * BODY_WHEEL_RADIUS_UM) * 18817 / 21728;

/* Of a body that turns at 1 urad/s. */
static const int64_t TURNING_Q24 =
    (INT64_C(256) * BODY_COUNTS_PER_TURN * 113 * (INT64_C(1) << 24)) /
    (INT64_C(2) * 355 * BODY_WHEEL_RADIUS_UM) * BODY_CENTRE_TO_WHEEL_UM / 1000000;

static int32_t rounded_q24(int64_t value)
{
    return (int32_t)((value + (INT64_C(1) << 23)) >> 24);
}

void wheel_rates_from_twist(const struct twist *twist, struct wheel_rates *rates)
{
    int64_t along = ALONG_Q24 * twist->vx_um_s;
    int64_t aside = RATE_Q24 * twist->vy_um_s;
    int64_t turning = TURNING_Q24 * twist->w_urad_s;

    rates->q8[0] = rounded_q24(along - aside / 2 + turning);
    rates->q8[1] = rounded_q24(aside + turning);
    rates->q8[2] = rounded_q24(-along - aside / 2 + turning);
}

static int32_t magnitude(int32_t rate)
{
    return rate < 0 ? -rate : rate;
}

void wheel_rates_limit(struct wheel_rates *rates)
{
    int32_t fastest = 0;

    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        if (magnitude(rates->q8[i]) > fastest) {
            fastest = magnitude(rates->q8[i]);
        }
    }
    if (fastest <= WHEEL_MAX_RATE_Q8) {
        return;
    }
    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        rates->q8[i] = (int32_t)((int64_t)rates->q8[i] * WHEEL_MAX_RATE_Q8 / fastest);
    }
}
