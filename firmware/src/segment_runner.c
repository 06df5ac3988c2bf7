#include "segment_runner.h"

#include <string.h>

/* From this error on the reference slows down; at the second it waits. */
static const int32_t SLOWING_UM = 20000;
static const int32_t WAITING_UM = 50000;

static const int32_t SETTLED_UM = 1000;
static const int32_t SETTLED_URAD = 2000;

/* Settled stays settled within this many times the tolerance. */
enum { HYSTERESIS = 3 };

void segment_runner_begin(struct segment_runner *runner)
{
    memset(runner, 0, sizeof *runner);
    segment_queue_begin(&runner->queue);
}

void segment_runner_start(struct segment_runner *runner, const struct pose *here, uint16_t pace_q15,
                          const struct segment_limits *limits)
{
    segment_queue_start(&runner->queue, here, pace_q15, limits);
    for (uint8_t i = 0; i < SEGMENT_RUNNER_RESPONSE_MOVES; i++) {
        runner->past_references[i] = *here;
    }
    runner->next = 0;
    memset(&runner->error, 0, sizeof runner->error);
    memset(&runner->twist, 0, sizeof runner->twist);
    runner->is_correcting = false;
    runner->is_active = true;
    runner->is_onward = true;
    runner->is_settled = false;
}

void segment_runner_stop(struct segment_runner *runner)
{
    segment_queue_stop(&runner->queue);
    runner->is_active = false;
}

static int32_t magnitude(int32_t value)
{
    return value < 0 ? -value : value;
}

static bool is_near(const struct tracking_error *error, int32_t tolerances)
{
    return magnitude(error->x_um) <= SETTLED_UM * tolerances &&
           magnitude(error->y_um) <= SETTLED_UM * tolerances &&
           magnitude(error->heading_urad) <= SETTLED_URAD * tolerances;
}

static uint16_t wanted_pace_q15(const struct segment_runner *runner)
{
    int32_t far_um = magnitude(runner->error.x_um) + magnitude(runner->error.y_um);

    if (!runner->is_onward || far_um >= WAITING_UM) {
        return 0;
    }
    if (far_um <= SLOWING_UM) {
        return SEGMENT_PACE_Q15;
    }
    return (uint16_t)((uint32_t)(WAITING_UM - far_um) * SEGMENT_PACE_Q15 /
                      (uint32_t)(WAITING_UM - SLOWING_UM));
}

static void move_reference(struct segment_runner *runner, uint16_t ms)
{
    segment_queue_advance(&runner->queue, wanted_pace_q15(runner), ms);
    runner->past_references[runner->next] = runner->queue.reference;
    runner->next = (uint8_t)((runner->next + 1) % SEGMENT_RUNNER_RESPONSE_MOVES);
}

static void correct(struct segment_runner *runner, const struct pose *robot)
{
    static const struct twist still = {0, 0, 0};

    runner->error = tracking_error_of(robot, &runner->past_references[runner->next]);
    runner->is_settled = segment_queue_is_standing(&runner->queue) &&
                         (runner->queue.count == 0 || !runner->is_onward) &&
                         is_near(&runner->error, runner->is_settled ? HYSTERESIS : 1);
    if (runner->is_settled) {
        runner->twist = still;
    } else {
        struct twist reference = segment_queue_twist(&runner->queue);

        runner->twist = tracking_twist(&runner->error, &reference);
    }
}

struct twist segment_runner_tick(struct segment_runner *runner, const struct pose *robot,
                                 uint16_t ms)
{
    if (runner->is_correcting) {
        correct(runner, robot);
    } else {
        move_reference(runner, (uint16_t)(2 * ms));
    }
    runner->is_correcting = !runner->is_correcting;
    return runner->twist;
}
