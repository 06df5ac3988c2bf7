/*
 * Drives the robot along a queue of segments. The reference runs ahead and waits for a robot that
 * falls behind; at the end the robot is corrected towards it until it is within a millimetre. In one
 * tick the reference is moved, in the next one the robot is corrected, so that no tick is long.
 */
#ifndef SEGMENT_RUNNER_H
#define SEGMENT_RUNNER_H

#include <stdbool.h>
#include <stdint.h>

#include "pose.h"
#include "segment.h"
#include "tracking.h"
#include "twist.h"

enum {
    /*
     * Moves of the reference after which the wheels are as fast as commanded. The robot is compared
     * with where the reference was then; else it would be pushed while it speeds up and run on when
     * it slows down.
     */
    SEGMENT_RUNNER_RESPONSE_MOVES = 2,
};

struct segment_runner {
    struct segment_queue queue;
    struct pose past_references[SEGMENT_RUNNER_RESPONSE_MOVES]; /* the oldest is next */
    uint8_t next;
    struct tracking_error error; /* as it was last */
    struct twist twist;          /* to drive */
    bool is_correcting;          /* in the next tick; else it moves the reference */
    bool is_active;  /* drives a path, or stands on it */
    bool is_onward;  /* else it slows down on the path, and stands */
    bool is_settled; /* the reference is stopped, and the robot at its place */
};

void segment_runner_begin(struct segment_runner *runner);

/* Begins a path; the reference is here, and has this pace. */
void segment_runner_start(struct segment_runner *runner, const struct pose *here, uint16_t pace_q15,
                          const struct segment_limits *limits);

/* Drops the path. */
void segment_runner_stop(struct segment_runner *runner);

/* Every ms milliseconds; returns the velocity to drive. */
struct twist segment_runner_tick(struct segment_runner *runner, const struct pose *robot,
                                 uint16_t ms);

#endif
