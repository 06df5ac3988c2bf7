#include "odometry.h"

#include <string.h>

/* More counts than this between two updates are none of a wheel: 0.2 s at the rated speed. */
static const int32_t MOST_COUNTS = 2000;

/*
 * vx = (v1 - v3)/sqrt(3), vy = (2 v2 - v1 - v3)/3: um a count, times 2^24; 2 pi = 710/113 and
 * sqrt(3) = 18817/10864. At most 84 and 49 um a count.
 * w = (v1 + v2 + v3)/(3 R): r/(3 R) turns of the body a turn of the wheels; 65,000 um times 2^48 is
 * the most that 64 bits hold.
 */
static struct odometry_scale scale_of(const struct settings *settings)
{
    int64_t turn_um_q24 = INT64_C(710) * settings->wheel_radius_um * (INT64_C(1) << 24) / 113;
    struct odometry_scale scale;

    scale.along_q24 = (int32_t)(turn_um_q24 * 10864 / 18817 / BODY_COUNTS_PER_TURN);
    scale.aside_q24 = (int32_t)(turn_um_q24 / (3 * BODY_COUNTS_PER_TURN));
    scale.heading_q16 = (UINT64_C(1) << 48) * settings->wheel_radius_um /
                        (UINT64_C(3) * settings->centre_to_wheel_um * BODY_COUNTS_PER_TURN);
    return scale;
}

_Static_assert(SETTINGS_MOST_WHEEL_RADIUS_UM < 65536, "2^48 of them are more than 64 bits");

static uint32_t heading(const struct odometry *odometry)
{
    return odometry->first_heading +
           (uint32_t)((odometry->scale.heading_q16 * (uint64_t)odometry->turned) >> 16);
}

static int32_t counted(int32_t now, int32_t before)
{
    int32_t moved = (int32_t)((uint32_t)now - (uint32_t)before);

    if (moved > MOST_COUNTS) {
        return MOST_COUNTS;
    }
    return moved < -MOST_COUNTS ? -MOST_COUNTS : moved;
}

static int32_t um_q8(int32_t um_a_count_q24, int32_t counts)
{
    return (int32_t)(((int64_t)um_a_count_q24 * counts + (1 << 15)) >> 16);
}

void odometry_begin(struct odometry *odometry, const int32_t counts[BODY_WHEELS],
                    const struct settings *settings)
{
    memset(odometry, 0, sizeof *odometry);
    memcpy(odometry->counts, counts, sizeof odometry->counts);
    odometry->scale = scale_of(settings);
}

void odometry_set_wheels(struct odometry *odometry, const struct settings *settings)
{
    odometry->first_heading = odometry->pose.heading;
    odometry->turned = 0;
    odometry->scale = scale_of(settings);
}

void odometry_update(struct odometry *odometry, const int32_t counts[BODY_WHEELS])
{
    int32_t moved[BODY_WHEELS];
    struct step step;

    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        moved[i] = counted(counts[i], odometry->counts[i]);
        odometry->turned += moved[i];
    }
    memcpy(odometry->counts, counts, sizeof odometry->counts);
    step.x_um_q8 = um_q8(odometry->scale.along_q24, moved[0] - moved[2]);
    step.y_um_q8 = um_q8(odometry->scale.aside_q24, 2 * moved[1] - moved[0] - moved[2]);
    step.turn = (int32_t)(heading(odometry) - odometry->pose.heading);
    pose_advance(&odometry->pose, &step);
}
