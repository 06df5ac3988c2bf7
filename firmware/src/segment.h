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
#define SEGMENT_LONGEST_US UINT32_C(3600000000)

/* The least and the most of a reference's acceleration, mm/s2 and mrad/s2. */
#define SEGMENT_LEAST_RATE 10
#define SEGMENT_HIGHEST_RATE 50000

/* A whole pace, as planned. */
#define SEGMENT_PACE_Q15 UINT16_C(32768)

struct segment {
    int32_t v_um_s; /* forward */
    int32_t w_urad_s;
    uint32_t duration_us;
};

/* How abruptly the reference may change its velocity. */
struct segment_limits {
    uint16_t acceleration_mm_s2;
    uint16_t turn_acceleration_mrad_s2;
};

struct segment_queue {
    struct segment segments[SEGMENT_QUEUE_LENGTH];
    int32_t um_a_us_q24[SEGMENT_QUEUE_LENGTH];     /* at the planned pace */
    int32_t turn_a_us_q16[SEGMENT_QUEUE_LENGTH];   /* likewise; 2^32 a turn */
    uint32_t pace_rate_q15[SEGMENT_QUEUE_LENGTH];  /* how much the pace may change in a second */
    uint32_t gain_q30[SEGMENT_QUEUE_LENGTH];       /* of the pace's square, braked over it all */
    uint16_t entry_pace_q15[SEGMENT_QUEUE_LENGTH]; /* at most, where it joins the one before */
    uint16_t exit_pace_q15[SEGMENT_QUEUE_LENGTH];  /* at most, at its end */
    uint8_t first;
    uint8_t count;
    struct segment_limits limits;
    uint16_t driven;     /* segments of the path; wraps around */
    uint32_t covered_us; /* planned time of the first one that is behind the reference */
    uint16_t pace_q15;
    struct pose reference;
};

void segment_queue_begin(struct segment_queue *queue);

/* Begins a path: drops all segments; the reference is here, and has this pace. */
void segment_queue_start(struct segment_queue *queue, const struct pose *here, uint16_t pace_q15,
                         const struct segment_limits *limits);

/* Returns how many of them the queue had room for, the first ones. */
uint8_t segment_queue_add(struct segment_queue *queue, const struct segment *segments,
                          uint8_t count);

/* Drops all segments; the reference stops where it is. */
void segment_queue_stop(struct segment_queue *queue);

/* Moves the reference on; wanted_pace_q15: 2^15 as planned, less to wait. */
void segment_queue_advance(struct segment_queue *queue, uint16_t wanted_pace_q15, uint16_t ms);

/* The reference's velocity, in its own frame. */
struct twist segment_queue_twist(const struct segment_queue *queue);

static inline bool segment_queue_is_standing(const struct segment_queue *queue)
{
    return queue->pace_q15 == 0;
}

#endif
