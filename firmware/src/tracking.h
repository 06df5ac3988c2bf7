/*
 * How the robot follows a moving reference: the reference's velocity fed forward, and a bounded
 * velocity towards it in proportion to the error, in each of x, y and heading; time constant 1/3 s.
 */
#ifndef TRACKING_H
#define TRACKING_H

#include <stdint.h>

#include "pose.h"
#include "twist.h"

/* Where the reference is, seen from the robot. */
struct tracking_error {
    int32_t x_um; /* forward */
    int32_t y_um; /* left */
    int32_t heading_urad;
};

struct tracking_error tracking_error_of(const struct pose *robot, const struct pose *reference);

/* feed_forward: in the reference's frame. Returns the velocity to drive, in the robot's frame. */
struct twist tracking_twist(const struct tracking_error *error, const struct twist *feed_forward);

#endif
