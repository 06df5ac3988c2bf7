#include "segment_runner.h"

#include <string.h>

#include "tracking.h"

/* From this error on the reference slows down; at the second it waits. */
static const int32_t SLOWING_UM = 50000;
static const int32_t WAITING_UM = 150000;

static const int32_t SETTLED_UM = 1000;
static const int32_t SETTLED_URAD = 2000;

static const uint16_t AS_PLANNED_Q15 = UINT16_C(1) << 15;

void segment_runner_begin(struct segment_runner *runner)
{
    static const struct pose origin = {0, 0, 0};

    segment_queue_begin(&runner->queue);
    segment_runner_reset(runner, &origin);
}

void segment_runner_reset(struct segment_runner *runner, const struct pose *here)
{
    segment_queue_reset(&runner->queue, here);
    for (uint8_t i = 0; i < SEGMENT_RUNNER_RESPONSE_TICKS; i++) {
        runner->past_references[i] = *here;
    }
    runner->next = 0;
    runner->is_halting = false;
    runner->is_settled = true;
}

bool segment_runner_add(struct segment_runner *runner, const struct segment *segment)
{
    if (!segment_queue_add(&runner->queue, segment)) {
        return false;
    }
    runner->is_halting = false;
    runner->is_settled = false;
    return true;
}

void segment_runner_halt(struct segment_runner *runner)
{
    runner->is_halting = true;
}

static int32_t magnitude(int32_t value)
{
    return value < 0 ? -value : value;
}

static bool is_near(const struct tracking_error *error)
{
    return magnitude(error->x_um) <= SETTLED_UM && magnitude(error->y_um) <= SETTLED_UM &&
           magnitude(error->heading_urad) <= SETTLED_URAD;
}

static uint16_t wanted_pace_q15(const struct segment_runner *runner,
                                const struct tracking_error *error)
{
    int32_t far_um = magnitude(error->x_um) + magnitude(error->y_um);

    if (runner->is_halting || far_um >= WAITING_UM) {
        return 0;
    }
    if (far_um <= SLOWING_UM) {
        return AS_PLANNED_Q15;
    }
    return (uint16_t)((uint32_t)(WAITING_UM - far_um) * AS_PLANNED_Q15 /
                      (uint32_t)(WAITING_UM - SLOWING_UM));
}

struct twist segment_runner_tick(struct segment_runner *runner, const struct pose *robot,
                                 uint16_t ms)
{
    static const struct twist still = {0, 0, 0};
    struct tracking_error error = tracking_error_of(robot, &runner->past_references[runner->next]);
    struct twist reference;

    segment_queue_advance(&runner->queue, wanted_pace_q15(runner, &error), ms);
    runner->past_references[runner->next] = runner->queue.reference;
    runner->next = (uint8_t)((runner->next + 1) % SEGMENT_RUNNER_RESPONSE_TICKS);
    if (segment_queue_is_standing(&runner->queue)) {
        if (runner->is_halting || (runner->queue.count == 0 && is_near(&error))) {
            segment_runner_reset(runner, robot);
            return still;
        }
    }
    reference = segment_queue_twist(&runner->queue);
    return tracking_twist(&error, &reference);
}
