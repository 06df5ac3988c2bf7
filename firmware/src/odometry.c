#include "odometry.h"

#include <string.h>

/*
 * vx = (v1 - v3)/sqrt(3), vy = (2 v2 - v1 - v3)/3: um a count, times 2^24; 2 pi = 710/113 and
 * sqrt(3) = 18817/10864.
 */
static const int32_t ALONG_Q24 =
    (INT64_C(710) * BODY_WHEEL_RADIUS_UM * (INT64_C(1) << 24) / 113) * 10864 / 18817 / BODY_COUNTS_PER_TURN;
static const int32_t ASIDE_Q24 =
    (INT64_C(710) * BODY_WHEEL_RADIUS_UM * (INT64_C(1) << 24) / 113) / (3 * BODY_COUNTS_PER_TURN);

_Static_assert(BODY_WHEEL_RADIUS_UM < 65536, "2^48 of them are more than 64 bits");

/* w = (v1 + v2 + v3)/(3 R): r/(3 R) turns of the body a turn of the wheels, times 2^16. */
static const uint64_t HEADING_Q16 = (UINT64_C(1) << 48) * BODY_WHEEL_RADIUS_UM /
                                    (UINT64_C(3) * BODY_CENTRE_TO_WHEEL_UM * BODY_COUNTS_PER_TURN);

static uint32_t heading(int64_t turned)
{
    return (uint32_t)((HEADING_Q16 * (uint64_t)turned) >> 16);
}

static int32_t um_q8(int32_t um_a_count_q24, int32_t counts)
{
    return (int32_t)(((int64_t)um_a_count_q24 * counts + (1 << 15)) >> 16);
}

void odometry_begin(struct odometry *odometry, const int32_t counts[BODY_WHEELS])
{
    memset(odometry, 0, sizeof *odometry);
    memcpy(odometry->counts, counts, sizeof odometry->counts);
}

void odometry_update(struct odometry *odometry, const int32_t counts[BODY_WHEELS])
{
    int32_t moved[BODY_WHEELS];
    struct step step;

    for (uint8_t i = 0; i < BODY_WHEELS; i++) {
        moved[i] = (int32_t)((uint32_t)counts[i] - (uint32_t)odometry->counts[i]);
        odometry->turned += moved[i];
    }
    memcpy(odometry->counts, counts, sizeof odometry->counts);
    step.x_um_q8 = um_q8(ALONG_Q24, moved[0] - moved[2]);
    step.y_um_q8 = um_q8(ASIDE_Q24, 2 * moved[1] - moved[0] - moved[2]);
    step.turn = (int32_t)(heading(odometry->turned) - odometry->pose.heading);
    pose_advance(&odometry->pose, &step);
}
