/*
 * Drives the robot along a queue of segments. The reference runs ahead and waits for a robot that
 * falls behind; at the end the robot is drawn onto it until it stands within a millimetre.
 */
#ifndef FOLLOWER_H
#define FOLLOWER_H

#include <stdbool.h>
#include <stdint.h>

#include "pose.h"
#include "segment.h"
#include "twist.h"

enum {
    /*
     * Ticks after which the wheels are as fast as they were told. The robot is compared with where
     * the reference was then; else it would be pushed while it speeds up and run on when it slows
     * down.
     */
    FOLLOWER_RESPONSE_TICKS = 3,
};

struct follower {
    struct segment_queue queue;
    struct pose trail[FOLLOWER_RESPONSE_TICKS]; /* of the reference; the oldest is next */
    uint8_t next;
    bool is_halting;
    bool is_settled; /* stands on the reference, which stands too */
};

void follower_begin(struct follower *follower);

/* Forgets all segments; the way goes on from here. */
void follower_place(struct follower *follower, const struct pose *here);

bool follower_add(struct follower *follower, const struct segment *segment);

/* Slows down, stands, and forgets the segments. */
void follower_halt(struct follower *follower);

/* Returns the velocity to drive. */
struct twist follower_tick(struct follower *follower, const struct pose *robot, uint16_t ms);

#endif
