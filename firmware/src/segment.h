/*
 * Curve segments and the reference that runs along them. The reference has a pace between 0
 * (stopped) and 1 (as planned), which scales time and not the curve. It rises and falls with the
 * limits of acceleration. Before the end of the queue, and before a corner where the velocity
 * jumps, it falls in time: a backward pass over the queue finds with which pace each segment may be
 * left (the look-ahead of machine-tool controllers, with a junction limit as in grbl).
 */
#ifndef SEGMENT_H
#define SEGMENT_H

#include <stdbool.h>
#include <stdint.h>

#include "pose.h"
#include "twist.h"

#define SEGMENT_QUEUE_LENGTH 16
#define SEGMENT_LONGEST_MS UINT32_C(600000)

struct segment {
    int32_t v_um_s; /* forward */
    int32_t w_urad_s;
    uint32_t duration_ms;
};

struct segment_queue {
    struct segment segments[SEGMENT_QUEUE_LENGTH];
    uint32_t pace_rate_q15[SEGMENT_QUEUE_LENGTH];  /* how much the pace may change in a second */
    uint32_t gain_q30[SEGMENT_QUEUE_LENGTH];       /* of the pace's square, braked over it all */
    uint16_t entry_pace_q15[SEGMENT_QUEUE_LENGTH]; /* at most, where it joins the one before */
    uint16_t exit_pace_q15[SEGMENT_QUEUE_LENGTH];  /* at most, at its end */
    uint8_t first;
    uint8_t count;
    uint16_t driven;     /* segments since the start; wraps around */
    uint32_t covered_us; /* planned time of the first one that is behind the reference */
    uint16_t pace_q15;
    struct pose reference;
};

void segment_queue_begin(struct segment_queue *queue);

/* Returns false where the queue is full. */
bool segment_queue_add(struct segment_queue *queue, const struct segment *segment);

/* Drops all segments; the reference stops here. */
void segment_queue_reset(struct segment_queue *queue, const struct pose *here);

/* Moves the reference on; wanted_pace_q15: 2^15 as planned, less to wait. */
void segment_queue_advance(struct segment_queue *queue, uint16_t wanted_pace_q15, uint16_t ms);

/* The reference's velocity, in its own frame. */
struct twist segment_queue_twist(const struct segment_queue *queue);

static inline bool segment_queue_is_standing(const struct segment_queue *queue)
{
    return queue->pace_q15 == 0;
}

#endif
