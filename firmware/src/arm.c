#include "arm.h"

#include <string.h>

#include "square_root.h"

enum {
    ALL_MEASURED = (1 << ARM_CHANNELS) - 1,
    TICKS_A_SECOND = 1000 / ARM_PERIOD_MS,
    PULSES_A_US = 2,
    COARSE = 4, /* bits: 16 urad, so that products have 32 bits */
};

static uint32_t size_of(int32_t value)
{
    return value < 0 ? 0U - (uint32_t)value : (uint32_t)value;
}

static bool is_known(const struct arm *arm)
{
    return arm->measured == ALL_MEASURED;
}

bool arm_is_fitted(const struct arm *arm)
{
    return arm->settings.joints[0].most_urad > arm->settings.joints[0].least_urad;
}

void arm_begin(struct arm *arm, const struct arm_settings *settings)
{
    memset(arm, 0, sizeof *arm);
    arm->settings = *settings;
}

/* value of from..to in the place that at has in begin..end; beyond the ends, the end. */
static uint32_t placed(uint32_t at, uint32_t begin, uint32_t end, uint32_t span)
{
    uint32_t low = begin < end ? begin : end;
    uint32_t high = begin < end ? end : begin;
    uint32_t within = at < low ? low : at > high ? high : at;

    return (begin < end ? within - begin : begin - within) * span / (high - low);
}

static int32_t angle_of(const struct arm_joint_settings *joint, uint16_t mv)
{
    uint32_t span = (uint32_t)(joint->most_urad - joint->least_urad) >> COARSE;

    return joint->least_urad +
           (int32_t)(placed(mv, joint->mv_least, joint->mv_most, span) << COARSE);
}

static uint16_t grams_of(const struct arm_settings *settings, uint16_t mv)
{
    uint32_t above = mv <= settings->empty_mv ? 0U : (uint32_t)mv - settings->empty_mv;

    return (uint16_t)(above * 1000U / settings->mv_a_kg);
}

/* Ends the line where the joints are. */
static void stand(struct arm *arm)
{
    arm->length_urad = 0;
    arm->covered_urad = 0;
    arm->rate_urad_s = 0;
    arm->is_braking = false;
}

static void stand_as_measured(struct arm *arm)
{
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        arm->joints[i].at_urad = arm->joints[i].measured_urad;
    }
    stand(arm);
}

void arm_measure(struct arm *arm, enum arm_channel channel, uint16_t mv)
{
    bool was_known = is_known(arm);

    if (channel == ARM_SHOULDER || channel == ARM_ELBOW) {
        arm->joints[channel].measured_urad = angle_of(&arm->settings.joints[channel], mv);
    } else if (channel == ARM_LOAD) {
        arm->load_g = grams_of(&arm->settings, mv);
    }
    arm->measured = (uint8_t)(arm->measured | 1U << channel);
    if (!was_known && is_known(arm)) {
        stand_as_measured(arm);
        for (uint8_t i = 0; i < ARM_JOINTS; i++) {
            arm->goal_urad[i] = arm->joints[i].at_urad;
        }
        arm->is_hand_closed = arm->load_g >= ARM_LEAST_LOAD_G;
    }
}

static bool is_at_goal(const struct arm *arm)
{
    return arm->joints[0].at_urad == arm->goal_urad[0] &&
           arm->joints[1].at_urad == arm->goal_urad[1];
}

bool arm_is_moving(const struct arm *arm)
{
    return arm->length_urad != 0;
}

enum answer arm_move(struct arm *arm, const struct arm_goal *goal, uint32_t now_ms)
{
    if (!arm_is_fitted(arm) || !is_known(arm)) {
        return ANSWER_NO_ARM;
    }
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        const struct arm_joint_settings *joint = &arm->settings.joints[i];

        if (goal->urad[i] < joint->least_urad || goal->urad[i] > joint->most_urad) {
            return ANSWER_OUT_OF_RANGE;
        }
    }
    if (memcmp(goal->urad, arm->goal_urad, sizeof goal->urad) != 0) {
        memcpy(arm->goal_urad, goal->urad, sizeof goal->urad);
        arm->is_stalled = false;
        arm->behind_ms = 0;
        arm->is_braking = arm_is_moving(arm);
    }
    arm->is_onward = goal->is_onward;
    arm->is_hand_closed = goal->is_hand_closed;
    arm->set_ms = now_ms;
    return ANSWER_DONE;
}

/* A limit of one joint as one of the line: the joint turns the share of it that change is. */
static void limit(uint32_t *most, uint16_t thousandths, uint32_t length, uint32_t change)
{
    uint64_t of_line = (uint64_t)thousandths * 1000U * length / change;

    if (of_line < *most) {
        *most = (uint32_t)of_line;
    }
}

static void begin_line(struct arm *arm)
{
    uint32_t length = 0;

    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        struct arm_joint *joint = &arm->joints[i];

        joint->from_urad = joint->at_urad;
        joint->change_urad = arm->goal_urad[i] - joint->at_urad;
        if (size_of(joint->change_urad) > length) {
            length = size_of(joint->change_urad);
        }
    }
    arm->most_rate_urad_s = UINT32_MAX;
    arm->acceleration_urad_s2 = UINT32_MAX;
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        const struct arm_joint_settings *joint = &arm->settings.joints[i];
        uint32_t change = size_of(arm->joints[i].change_urad);

        if (change != 0) {
            limit(&arm->most_rate_urad_s, joint->rate_mrad_s, length, change);
            limit(&arm->acceleration_urad_s2, joint->acceleration_mrad_s2, length, change);
        }
    }
    arm->length_urad = length;
    arm->covered_urad = 0;
    arm->rate_urad_s = 0;
}

static uint32_t wide_square_root(uint64_t square)
{
    uint8_t shift = 0;

    while (square > UINT32_MAX) {
        square >>= 2;
        shift++;
    }
    return (uint32_t)square_root((uint32_t)square) << shift;
}

/*
 * The rate from which the end is still reached by slowing down within the acceleration a, tick by
 * tick: v dt + v^2 / 2a is what is left.
 */
static uint32_t rate_before_end(uint32_t left, uint32_t acceleration, uint32_t change_a_tick)
{
    uint64_t square =
        (uint64_t)change_a_tick * change_a_tick + UINT64_C(2) * acceleration * left;

    return wide_square_root(square) - change_a_tick;
}

static uint32_t lesser(uint32_t one, uint32_t other)
{
    return one < other ? one : other;
}

static void follow_line(struct arm *arm, bool is_onward)
{
    uint32_t change = arm->acceleration_urad_s2 / TICKS_A_SECOND;
    uint32_t left = arm->length_urad - arm->covered_urad;
    uint32_t step;

    if (!is_onward) {
        arm->rate_urad_s = arm->rate_urad_s > change ? arm->rate_urad_s - change : 0;
    } else {
        arm->rate_urad_s = lesser(lesser(arm->rate_urad_s + change, arm->most_rate_urad_s),
                                  rate_before_end(left, arm->acceleration_urad_s2, change));
    }
    step = arm->rate_urad_s / TICKS_A_SECOND;
    arm->covered_urad += lesser(is_onward && step == 0 ? 1 : step, left);
    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        struct arm_joint *joint = &arm->joints[i];

        joint->at_urad = joint->from_urad + (int32_t)((int64_t)joint->change_urad *
                                                      arm->covered_urad / arm->length_urad);
    }
    if (arm->covered_urad == arm->length_urad || (!is_onward && arm->rate_urad_s == 0)) {
        stand(arm);
    }
}

static bool is_behind(const struct arm *arm, uint8_t i)
{
    const struct arm_joint *joint = &arm->joints[i];

    return size_of(joint->measured_urad - joint->at_urad) >
           ARM_BEHIND_URAD + UINT32_C(100) * arm->settings.joints[i].rate_mrad_s;
}

static void find_stall(struct arm *arm)
{
    arm->behind_ms = is_behind(arm, 0) || is_behind(arm, 1)
                         ? (uint16_t)(arm->behind_ms + ARM_PERIOD_MS)
                         : 0;
    if (arm->behind_ms >= ARM_STALL_MS) {
        stand_as_measured(arm);
        arm->is_stalled = true;
        arm->behind_ms = 0;
    }
}

void arm_tick(struct arm *arm, uint32_t now_ms, bool may_begin)
{
    bool is_onward = arm->is_onward && now_ms - arm->set_ms < ARM_GOAL_LIFE_MS;

    if (!arm_is_fitted(arm) || !is_known(arm)) {
        return;
    }
    find_stall(arm);
    if (arm_is_moving(arm)) {
        follow_line(arm, is_onward && !arm->is_braking);
    } else if (may_begin && is_onward && !arm->is_stalled && !is_at_goal(arm)) {
        begin_line(arm);
    }
}

void arm_halt(struct arm *arm)
{
    arm->is_onward = false;
    stand(arm);
}

uint16_t arm_pulse(const struct arm *arm, enum arm_channel channel)
{
    const struct arm_settings *settings = &arm->settings;
    const struct arm_joint_settings *joint = &settings->joints[channel == ARM_ELBOW ? 1 : 0];
    uint32_t least = (uint32_t)joint->pulse_least_us * PULSES_A_US;
    uint32_t most = (uint32_t)joint->pulse_most_us * PULSES_A_US;
    uint32_t turned;

    if (!arm_is_fitted(arm) || !is_known(arm) || channel == ARM_LOAD) {
        return 0;
    }
    if (channel == ARM_HAND) {
        return (uint16_t)((arm->is_hand_closed ? settings->closed_us : settings->open_us) *
                          PULSES_A_US);
    }
    turned = placed((uint32_t)(arm->joints[channel].at_urad - joint->least_urad) >> COARSE, 0,
                    (uint32_t)(joint->most_urad - joint->least_urad) >> COARSE,
                    least < most ? most - least : least - most);
    return (uint16_t)(least < most ? least + turned : least - turned);
}

static enum arm_state state_of(const struct arm *arm)
{
    if (!arm_is_fitted(arm) || !is_known(arm)) {
        return ARM_UNKNOWN;
    }
    return arm->is_stalled ? ARM_STALLED : arm_is_moving(arm) ? ARM_MOVING : ARM_STANDING;
}

struct arm_report arm_report_of(const struct arm *arm)
{
    struct arm_report report = {
        .state = state_of(arm),
        .is_hand_closed = arm->is_hand_closed,
        .load_g = arm->load_g,
        .progress = is_at_goal(arm) ? UINT8_MAX : 0,
    };

    for (uint8_t i = 0; i < ARM_JOINTS; i++) {
        const struct arm_joint *joint = &arm->joints[i];

        report.angle_urad[i] = size_of(joint->measured_urad - joint->at_urad) <= ARM_SAME_URAD
                                   ? joint->at_urad
                                   : joint->measured_urad;
        report.goal_urad[i] = arm->goal_urad[i];
    }
    if (arm_is_moving(arm)) { /* never 255: it is not there */
        report.progress = (uint8_t)((arm->covered_urad >> COARSE) * UINT32_C(254) /
                                    ((arm->length_urad >> COARSE) + 1U));
    }
    return report;
}
