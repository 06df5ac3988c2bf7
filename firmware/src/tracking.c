#include "tracking.h"

#include "angle.h"

enum { GAIN_A_SECOND = 3 };

/* The limits of the correction, however large the error. */
static const int32_t CORRECTION_UM_S = 100000;
static const int32_t TURN_CORRECTION_URAD_S = 500000;

static int32_t clamped(int64_t value, int32_t limit)
{
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : (int32_t)value;
}

struct tracking_error tracking_error_of(const struct pose *robot, const struct pose *reference)
{
    int64_t x = reference->x_um_q16 - robot->x_um_q16;
    int64_t y = reference->y_um_q16 - robot->y_um_q16;
    struct tracking_error error;

    pose_rotate(&x, &y, 0 - robot->heading);
    error.x_um = pose_um(x);
    error.y_um = pose_um(y);
    error.heading_urad = angle_urad(reference->heading - robot->heading);
    return error;
}

struct twist tracking_twist(const struct tracking_error *error, const struct twist *feed_forward)
{
    struct twist twist = *feed_forward;

    /* errors are small here: the reference's frame is taken for the robot's */
    twist.vx_um_s += clamped((int64_t)GAIN_A_SECOND * error->x_um, CORRECTION_UM_S);
    twist.vy_um_s += clamped((int64_t)GAIN_A_SECOND * error->y_um, CORRECTION_UM_S);
    twist.w_urad_s += clamped((int64_t)GAIN_A_SECOND * error->heading_urad, TURN_CORRECTION_URAD_S);
    return twist;
}
