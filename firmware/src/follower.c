#include "follower.h"

#include <string.h>

#include "tracking.h"

/* From this error on the reference slows down; at the second it waits. */
static const int32_t SLOWING_UM = 50000;
static const int32_t WAITING_UM = 150000;

static const int32_t SETTLED_UM = 1000;
static const int32_t SETTLED_URAD = 2000;

static const uint16_t AS_PLANNED_Q15 = UINT16_C(1) << 15;

void follower_begin(struct follower *follower)
{
    static const struct pose origin = {0, 0, 0};

    segment_queue_begin(&follower->queue);
    follower_place(follower, &origin);
}

void follower_place(struct follower *follower, const struct pose *here)
{
    segment_queue_place(&follower->queue, here);
    for (uint8_t i = 0; i < FOLLOWER_RESPONSE_TICKS; i++) {
        follower->trail[i] = *here;
    }
    follower->next = 0;
    follower->is_halting = false;
    follower->is_settled = true;
}

bool follower_add(struct follower *follower, const struct segment *segment)
{
    if (!segment_queue_add(&follower->queue, segment)) {
        return false;
    }
    follower->is_halting = false;
    follower->is_settled = false;
    return true;
}

void follower_halt(struct follower *follower)
{
    follower->is_halting = true;
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

static uint16_t wanted_pace_q15(const struct follower *follower, const struct tracking_error *error)
{
    int32_t far_um = magnitude(error->x_um) + magnitude(error->y_um);

    if (follower->is_halting || far_um >= WAITING_UM) {
        return 0;
    }
    if (far_um <= SLOWING_UM) {
        return AS_PLANNED_Q15;
    }
    return (uint16_t)((uint32_t)(WAITING_UM - far_um) * AS_PLANNED_Q15 /
                      (uint32_t)(WAITING_UM - SLOWING_UM));
}

struct twist follower_tick(struct follower *follower, const struct pose *robot, uint16_t ms)
{
    static const struct twist still = {0, 0, 0};
    struct tracking_error error = tracking_error_of(robot, &follower->trail[follower->next]);
    struct twist reference;

    segment_queue_advance(&follower->queue, wanted_pace_q15(follower, &error), ms);
    follower->trail[follower->next] = follower->queue.reference;
    follower->next = (uint8_t)((follower->next + 1) % FOLLOWER_RESPONSE_TICKS);
    if (segment_queue_stands(&follower->queue)) {
        if (follower->is_halting || (follower->queue.count == 0 && is_near(&error))) {
            follower_place(follower, robot);
            return still;
        }
    }
    reference = segment_queue_twist(&follower->queue);
    return tracking_twist(&error, &reference);
}
