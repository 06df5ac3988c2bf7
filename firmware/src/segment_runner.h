/*
 * Drives the robot along a queue of segments. The reference runs ahead and waits for a robot that
 * falls behind; at the end the robot is corrected towards it until it is within a millimetre.
 */
#ifndef SEGMENT_RUNNER_H
#define SEGMENT_RUNNER_H

#include <stdbool.h>
#include <stdint.h>

#include "pose.h"
#include "segment.h"
#include "twist.h"

enum {
    /*
     * Ticks after which the wheels are as fast as commanded. The robot is compared with where
     * the reference was then; else it would be pushed while it speeds up and run on when it slows
     * down.
     */
    SEGMENT_RUNNER_RESPONSE_TICKS = 3,
};

struct segment_runner {
    struct segment_queue queue;
    struct pose past_references[SEGMENT_RUNNER_RESPONSE_TICKS]; /* the oldest is next */
    uint8_t next;
    bool is_halting;
    bool is_settled; /* is stopped at the reference, which is stopped too */
};

void segment_runner_begin(struct segment_runner *runner);

/* Drops all segments; the path continues from here. */
void segment_runner_reset(struct segment_runner *runner, const struct pose *here);

bool segment_runner_add(struct segment_runner *runner, const struct segment *segment);

/* Slows down, stops, and drops the segments. */
void segment_runner_halt(struct segment_runner *runner);

/* Returns the velocity to drive. */
struct twist segment_runner_tick(struct segment_runner *runner, const struct pose *robot,
                                 uint16_t ms);

#endif
