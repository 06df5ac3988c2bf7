#include "tracking.h"

#include "angle.h"

enum { GAIN_A_SECOND = 3 };

/* The limits of the correction, however large the error. */
static const int32_t CORRECTION_UM_S = 100000;
static const int32_t TURN_CORRECTION_URAD_S = 500000;

/* No farther than this is told. */
static const int32_t FARTHEST_UM = 500000;

static int32_t clamped(int32_t value, int32_t limit)
{
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : value;
}

static int32_t difference_um(int64_t from_um_q16, int64_t to_um_q16)
{
    return clamped(pose_um(to_um_q16 - from_um_q16), FARTHEST_UM);
}

struct tracking_error tracking_error_of(const struct pose *robot, const struct pose *reference)
{
    struct tracking_error error;

    error.x_um = difference_um(robot->x_um_q16, reference->x_um_q16);
    error.y_um = difference_um(robot->y_um_q16, reference->y_um_q16);
    pose_rotate(&error.x_um, &error.y_um, 0 - robot->heading);
    error.heading_urad = angle_urad(reference->heading - robot->heading);
    return error;
}

struct twist tracking_twist(const struct tracking_error *error, const struct twist *feed_forward)
{
    struct twist twist = *feed_forward;

    /* errors are small here: the reference's frame is taken for the robot's */
    twist.vx_um_s += clamped(GAIN_A_SECOND * error->x_um, CORRECTION_UM_S);
    twist.vy_um_s += clamped(GAIN_A_SECOND * error->y_um, CORRECTION_UM_S);
    twist.w_urad_s += clamped(GAIN_A_SECOND * error->heading_urad, TURN_CORRECTION_URAD_S);
    return twist;
}
