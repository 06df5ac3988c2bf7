#include "wheel.h"

/* 2^32 times the rate at 1 um/s of a wheel with a radius of 1 um; pi = 355/113, off by 9e-8. */
static const int64_t RATE_UM_Q32 =
    INT64_C(256) * BODY_COUNTS_PER_TURN * 113 * (INT64_C(1) << 32) / (INT64_C(2) * 355);

struct wheel_scale wheel_scale_of(const struct settings *settings)
{
    int64_t rate_q32 = RATE_UM_Q32 / settings->wheel_radius_um; /* less than 2^36 */
    struct wheel_scale scale;

    scale.aside = (int32_t)(rate_q32 >> 8);
    /* sqrt(3)/2 = 18817/21728, off by 2e-9 */
    scale.along = (int32_t)(rate_q32 * 18817 / 21728 >> 8);
    scale.turning = (int32_t)(rate_q32 * settings->centre_to_wheel_um / 1000000 >> 8);
    return scale;
}

static int32_t rounded_q24(int64_t value)
{
    return (int32_t)((value + (INT64_C(1) << 23)) >> 24);
}

void wheel_rates_from_twist(const struct wheel_scale *scale, const struct twist *twist,
                            struct wheel_rates *rates)
{
    int64_t along = (int64_t)scale->along * twist->vx_um_s;
    int64_t aside = (int64_t)scale->aside * twist->vy_um_s;
    int64_t turning = (int64_t)scale->turning * twist->w_urad_s;

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
