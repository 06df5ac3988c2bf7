#include "segment.h"

#include <string.h>

#include "square_root.h"

/* Jumps of velocity that the motors can follow. */
static const uint32_t SPEED_JUMP_UM_S = 150000;
static const uint32_t TURN_JUMP_URAD_S = 800000;

static const uint32_t STEEPEST_PACE_A_SECOND = 10;

/* A segment with less than this left is driven. */
static const uint32_t INSTANT_US = 100;

/* No pace: of a segment that is not planned yet. */
static const uint16_t NOT_PLANNED = UINT16_MAX;

static const uint16_t ONE_Q15 = SEGMENT_PACE_Q15;
static const uint32_t ONE_Q30 = UINT32_C(1) << 30;

static uint8_t index_of(const struct segment_queue *queue, uint8_t place)
{
    return (uint8_t)((queue->first + place) % SEGMENT_QUEUE_LENGTH);
}

static const struct segment *segment_at(const struct segment_queue *queue, uint8_t place)
{
    return &queue->segments[index_of(queue, place)];
}

static uint32_t magnitude(int32_t value)
{
    return value < 0 ? 0 - (uint32_t)value : (uint32_t)value;
}

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* limit / |value|, at most `most`; all times 2^15. */
static uint32_t share_q15(uint32_t limit, uint32_t value, uint32_t most)
{
    while (limit > UINT32_MAX >> 15) { /* a division of 64 bits takes four times as long */
        limit >>= 1;
        value >>= 1;
    }
    return value == 0 ? most : least(limit * ONE_Q15 / value, most);
}

/* How much the pace may change in a second, times 2^15. */
static uint32_t pace_rate_q15(const struct segment *segment, const struct segment_limits *limits)
{
    const uint32_t steepest = STEEPEST_PACE_A_SECOND * ONE_Q15;
    uint32_t acceleration_um_s2 = limits->acceleration_mm_s2 * UINT32_C(1000);
    uint32_t turn_urad_s2 = limits->turn_acceleration_mrad_s2 * UINT32_C(1000);

    return least(share_q15(acceleration_um_s2, magnitude(segment->v_um_s), steepest),
                 share_q15(turn_urad_s2, magnitude(segment->w_urad_s), steepest));
}

static uint16_t junction_pace_q15(const struct segment *before, const struct segment *after)
{
    uint32_t speed_jump = magnitude(after->v_um_s - before->v_um_s);
    uint32_t turn_jump = magnitude(after->w_urad_s - before->w_urad_s);

    return (uint16_t)least(share_q15(SPEED_JUMP_UM_S, speed_jump, ONE_Q15),
                           share_q15(TURN_JUMP_URAD_S, turn_jump, ONE_Q15));
}

/*
 * By how much braking in so much planned time lowers the square of the pace, 2 a T; at most 2^31.
 * Times 2^30 that is rate_q15 * left_us * 2^16 / 10^6.
 */
static uint32_t braking_gain_q30(uint32_t rate_q15, uint32_t left_us)
{
    /* (2^20 / 10^6 - 1) 2^26 */
    static const uint32_t REST_Q26 = 3259880;
    uint64_t product = (uint64_t)rate_q15 * left_us;
    uint32_t sixteenth;

    if (product >= (uint64_t)ONE_Q30 << 5) { /* 2 a T is more than 2 */
        return 2 * ONE_Q30;
    }
    sixteenth = (uint32_t)(product >> 4);
    return sixteenth + (uint32_t)(((uint64_t)sixteenth * REST_Q26) >> 26);
}

/* The square of the pace that is braked to the exit pace: P^2 = p^2 + 2 a T. */
static uint32_t braked_square_q30(uint16_t exit_q15, uint32_t gain_q30)
{
    return (uint32_t)exit_q15 * exit_q15 + gain_q30;
}

static uint16_t root_q15(uint32_t square_q30)
{
    return square_q30 >= ONE_Q30 ? ONE_Q15 : square_root(square_q30);
}

/* The backward pass: from a standstill at the end of the queue to where nothing changes any more. */
static void plan_exit_paces(struct segment_queue *queue)
{
    uint16_t exit_q15 = 0;

    for (uint8_t place = queue->count; place-- > 0;) {
        uint8_t index = index_of(queue, place);
        bool is_last = place + 1 == queue->count;
        uint32_t square_q30;

        if (!is_last && queue->exit_pace_q15[index] == exit_q15) {
            break;
        }
        queue->exit_pace_q15[index] = exit_q15;
        square_q30 = braked_square_q30(exit_q15, queue->gain_q30[index]);
        exit_q15 = (uint16_t)least(root_q15(square_q30), queue->entry_pace_q15[index]);
    }
}

/* 2^24 / 10^6, times 2^20 */
static const int64_t UM_A_US_Q44 = 17592186;

/* 2^32 / (2 pi 10^12) 2^16, times 2^30 */
static const int64_t TURN_A_US_Q46 = INT64_C(48101630006);

static void compute_limits(struct segment_queue *queue, uint8_t place)
{
    const struct segment *segment = segment_at(queue, place);
    uint8_t index = index_of(queue, place);
    uint32_t rate_q15 = pace_rate_q15(segment, &queue->limits);

    queue->um_a_us_q24[index] = (int32_t)((segment->v_um_s * UM_A_US_Q44) >> 20);
    queue->turn_a_us_q16[index] = (int32_t)((segment->w_urad_s * TURN_A_US_Q46) >> 30);
    queue->pace_rate_q15[index] = rate_q15;
    queue->gain_q30[index] = braking_gain_q30(rate_q15, segment->duration_us);
    queue->entry_pace_q15[index] =
        place == 0 ? 0 : junction_pace_q15(segment_at(queue, (uint8_t)(place - 1)), segment);
}

void segment_queue_begin(struct segment_queue *queue)
{
    memset(queue, 0, sizeof *queue);
}

void segment_queue_start(struct segment_queue *queue, const struct pose *here, uint16_t pace_q15,
                         const struct segment_limits *limits)
{
    segment_queue_stop(queue);
    queue->limits = *limits;
    queue->driven = 0;
    queue->pace_q15 = pace_q15;
    queue->reference = *here;
}

uint8_t segment_queue_add(struct segment_queue *queue, const struct segment *segments,
                          uint8_t count)
{
    uint8_t added = 0;

    while (added < count && queue->count < SEGMENT_QUEUE_LENGTH) {
        queue->segments[index_of(queue, queue->count)] = segments[added];
        queue->exit_pace_q15[index_of(queue, queue->count)] = NOT_PLANNED;
        compute_limits(queue, queue->count);
        queue->count++;
        added++;
    }
    if (added != 0) {
        plan_exit_paces(queue);
    }
    return added;
}

void segment_queue_stop(struct segment_queue *queue)
{
    queue->count = 0;
    queue->covered_us = 0;
    queue->pace_q15 = 0;
}

static void move_reference(struct segment_queue *queue, uint32_t us)
{
    int32_t time_us = (int32_t)us;
    struct step step = {0, 0, 0};

    step.x_um_q8 = (int32_t)(((int64_t)queue->um_a_us_q24[queue->first] * time_us) >> 16);
    step.turn = (int32_t)(((int64_t)queue->turn_a_us_q16[queue->first] * time_us) >> 16);
    pose_advance(&queue->reference, &step);
    queue->covered_us += us;
}

static void drop_first(struct segment_queue *queue)
{
    queue->first = index_of(queue, 1);
    queue->count--;
    queue->driven++;
    queue->covered_us = 0;
}

/*
 * The highest pace of a tick that changes the pace by `change`, so that braking can begin with the
 * next one: P^2 = p^2 + 2 a (T - P tick).
 */
static uint16_t allowed_pace_q15(const struct segment_queue *queue, uint32_t change_q15)
{
    uint32_t left_us = segment_at(queue, 0)->duration_us - queue->covered_us;
    uint32_t gain_q30 = braking_gain_q30(queue->pace_rate_q15[queue->first], left_us);
    uint32_t square_q30 = braked_square_q30(queue->exit_pace_q15[queue->first], gain_q30);

    return (uint16_t)(square_root(square_q30 + change_q15 * change_q15) - change_q15);
}

/* Of less than 2^23; a division takes four times as long. */
static uint32_t thousandth(uint32_t value)
{
    return (uint32_t)(((uint64_t)value * UINT32_C(4294968)) >> 32);
}

static uint16_t next_pace_q15(const struct segment_queue *queue, uint16_t wanted_q15, uint16_t ms)
{
    uint32_t change_q15 = thousandth(queue->pace_rate_q15[queue->first] * ms);
    uint32_t slowest_q15 = queue->pace_q15 > change_q15 ? queue->pace_q15 - change_q15 : 0;
    uint32_t reachable_q15 = least(queue->pace_q15 + change_q15, wanted_q15);

    if (reachable_q15 < slowest_q15) {
        reachable_q15 = slowest_q15;
    }
    return (uint16_t)least(reachable_q15, allowed_pace_q15(queue, change_q15));
}

void segment_queue_advance(struct segment_queue *queue, uint16_t wanted_pace_q15, uint16_t ms)
{
    uint32_t time_us;

    if (queue->count == 0) {
        queue->pace_q15 = 0;
        return;
    }
    queue->pace_q15 = next_pace_q15(queue, wanted_pace_q15, ms);
    time_us = ((uint32_t)queue->pace_q15 * ms * 1000) >> 15;
    while (queue->count != 0 &&
           queue->covered_us + time_us + INSTANT_US >= segment_at(queue, 0)->duration_us) {
        uint32_t left_us = segment_at(queue, 0)->duration_us - queue->covered_us;

        move_reference(queue, left_us);
        time_us -= least(time_us, left_us);
        drop_first(queue);
    }
    if (queue->count == 0) {
        queue->pace_q15 = 0;
    } else {
        move_reference(queue, time_us);
    }
}

static int32_t at_pace(int32_t velocity, int32_t pace_q15)
{
    return (int32_t)(((int64_t)velocity * pace_q15) >> 15);
}

struct twist segment_queue_twist(const struct segment_queue *queue)
{
    struct twist twist = {0, 0, 0};

    if (queue->count != 0) {
        const struct segment *segment = segment_at(queue, 0);

        twist.vx_um_s = at_pace(segment->v_um_s, queue->pace_q15);
        twist.w_urad_s = at_pace(segment->w_urad_s, queue->pace_q15);
    }
    return twist;
}
