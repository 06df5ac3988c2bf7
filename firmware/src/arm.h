/*
 * An arm of two joints and a hand, each with a servo that a pulse tells where to stand; a
 * potentiometer at each joint, and a load sensor at the hand.
 *
 *   1. Sensors are measured in turn. When each was, the arm is known: it shall stand where it does,
 *      and its hand is closed where something hangs on it, so that a start drops nothing.
 *   2. arm_move says where the joints shall be, again and again: for 200 ms each time.
 *   3. arm_tick turns them there on the straight line between both stands, within the limits of each
 *      (a trapezoid of speed, as in the daemon's org.toqa.arm.JointTrajectory). Another goal, a hold
 *      and silence are obeyed by slowing down on that line.
 *   4. Joints that do not follow are relieved: they shall stand where they are, until the goal is
 *      another one.
 */
#ifndef ARM_H
#define ARM_H

#include <stdbool.h>
#include <stdint.h>

#include "command.h"

enum arm_channel { ARM_SHOULDER = 0, ARM_ELBOW = 1, ARM_HAND = 2, ARM_LOAD = 3, ARM_CHANNELS = 4 };

enum {
    ARM_PERIOD_MS = 10,
    ARM_GOAL_LIFE_MS = 200,
    ARM_STALL_MS = 500,
    ARM_LEAST_LOAD_G = 20, /* what weighs less is nothing */
};

/* A joint that is so near to where it shall be is there: as far as a potentiometer can tell. */
#define ARM_SAME_URAD 30000

/* So far a joint may be behind, beside what it turns in 0.1 s. */
#define ARM_BEHIND_URAD 200000

enum arm_state {
    ARM_UNKNOWN = 0, /* there is none, or it was not yet measured */
    ARM_STANDING = 1,
    ARM_MOVING = 2,
    ARM_STALLED = 3,
};

struct arm_joint {
    int32_t at_urad; /* where it shall be now */
    int32_t measured_urad;
    int32_t from_urad; /* of the line */
    int32_t change_urad;
};

struct arm {
    struct arm_settings settings;
    struct arm_joint joints[ARM_JOINTS];
    int32_t goal_urad[ARM_JOINTS];
    uint32_t length_urad; /* of the line: what the joint turns that turns farther; 0: none */
    uint32_t covered_urad;
    uint32_t rate_urad_s;
    uint32_t most_rate_urad_s;
    uint32_t acceleration_urad_s2;
    uint32_t set_ms; /* when the goal was said last */
    uint16_t behind_ms;
    uint16_t load_g;
    uint8_t measured; /* bit by channel; all: the arm is known */
    bool is_onward;
    bool is_hand_closed;
    bool is_braking; /* to another goal */
    bool is_stalled;
};

/* What the robot tells of its arm. */
struct arm_report {
    enum arm_state state;
    bool is_hand_closed;
    int32_t angle_urad[ARM_JOINTS];
    int32_t goal_urad[ARM_JOINTS];
    uint16_t load_g;
    uint8_t progress; /* 255: at its goal */
};

void arm_begin(struct arm *arm, const struct arm_settings *settings);

bool arm_is_fitted(const struct arm *arm);

/* Takes what a sensor measures; that of the hand is none. */
void arm_measure(struct arm *arm, enum arm_channel channel, uint16_t mv);

enum answer arm_move(struct arm *arm, const struct arm_goal *goal, uint32_t now_ms);

/* Every ARM_PERIOD_MS; may_begin: false while the robot drives or is stopped. */
void arm_tick(struct arm *arm, uint32_t now_ms, bool may_begin);

/* The joints shall stand where they are, at once. */
void arm_halt(struct arm *arm);

bool arm_is_moving(const struct arm *arm);

/* Of a servo, in units of 0.5 us; 0: none. */
uint16_t arm_pulse(const struct arm *arm, enum arm_channel channel);

struct arm_report arm_report_of(const struct arm *arm);

#endif
