/* The arm: within its limits wherever it goes, and what stops it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "check.h"
#include "tests.h"

/* Shoulder -160 to 160 degrees; the elbow's servo turns the other way. */
static const struct arm_settings SETTINGS = {
    .joints = {{-2792527, 2792527, 1571, 3142, 500, 2500, 500, 4500},
               {-2600000, 2700000, 2000, 5000, 2400, 600, 4500, 500}},
    .open_us = 1000,
    .closed_us = 2000,
    .empty_mv = 500,
    .mv_a_kg = 1000,
};

/* Servos that follow at once, unless they are stuck, and what measures them. */
struct model {
    struct bench bench;
    double share[ARM_JOINTS]; /* of its range, from its least angle */
    bool is_stuck;
    uint16_t load_mv;
    int channel;
    int32_t before[ARM_JOINTS];
    int32_t rate[ARM_JOINTS]; /* urad a tick */
};

static double pulse_share(const struct arm_joint_settings *joint, uint16_t pulse)
{
    return (pulse / 2.0 - joint->pulse_least_us) / (joint->pulse_most_us - joint->pulse_least_us);
}

static void measure(struct model *model)
{
    struct arm *arm = &model->bench.robot.arm;
    enum arm_channel channel = (enum arm_channel)model->channel;

    if (model->channel < ARM_JOINTS) {
        const struct arm_joint_settings *joint = &SETTINGS.joints[model->channel];
        uint16_t pulse = arm_pulse(arm, channel);

        if (pulse != 0 && !model->is_stuck) {
            model->share[model->channel] = pulse_share(joint, pulse);
        }
        arm_measure(arm, channel,
                    (uint16_t)lround(joint->mv_least +
                                     model->share[model->channel] *
                                         (joint->mv_most - joint->mv_least)));
    } else {
        arm_measure(arm, channel, model->load_mv);
    }
    model->channel = (model->channel + 1) % ARM_CHANNELS;
}

/* The limits, with what counting in whole numbers a tick of 10 ms costs. */
static void check_limits(struct model *model)
{
    for (int i = 0; i < ARM_JOINTS; i++) {
        const struct arm_joint_settings *joint = &SETTINGS.joints[i];
        int32_t at = model->bench.robot.arm.joints[i].at_urad;
        int32_t rate = at - model->before[i];

        CHECK(at >= joint->least_urad && at <= joint->most_urad);
        CHECK(abs(rate) <= joint->rate_mrad_s * 10 + 2);
        CHECK(abs(rate - model->rate[i]) <= joint->acceleration_mrad_s2 / 10 + 5);
        model->before[i] = at;
        model->rate[i] = rate;
    }
}

static void live(struct model *model, uint32_t ms)
{
    for (uint32_t i = 0; i < ms; i += 10) {
        bench_live(&model->bench, 5);
        measure(model);
        bench_live(&model->bench, 5);
        measure(model);
    }
}

static enum answer move(struct model *model, int32_t shoulder, int32_t elbow, bool is_onward)
{
    struct arm_goal goal = {{shoulder, elbow}, true, is_onward};

    return bench_arm(&model->bench, &goal);
}

static struct arm_report report_of(const struct model *model)
{
    return arm_report_of(&model->bench.robot.arm);
}

/* Until it is there, or for so long. Returns the ms. */
static uint32_t go(struct model *model, int32_t shoulder, int32_t elbow, uint32_t ms)
{
    for (uint32_t i = 0; i < ms; i += 20) {
        CHECK_EQUAL(ANSWER_DONE, move(model, shoulder, elbow, true));
        for (int tick = 0; tick < 2; tick++) {
            live(model, 10);
            check_limits(model);
        }
        if (report_of(model).progress == UINT8_MAX) {
            return i + 20;
        }
    }
    return ms;
}

static void begin(struct model *model)
{
    memset(model, 0, sizeof *model);
    model->share[0] = 0.25;
    model->share[1] = 0.75;
    model->load_mv = 500;
    bench_begin(&model->bench);
    bench_clear(&model->bench, STOP_POWER_UP, false);
    CHECK_EQUAL(ANSWER_DONE, bench_arm_settings(&model->bench, &SETTINGS));
    live(model, 20);
    for (int i = 0; i < ARM_JOINTS; i++) {
        model->before[i] = model->bench.robot.arm.joints[i].at_urad;
    }
}

static void there_is_no_arm_until_its_settings_came_and_it_was_measured(void)
{
    struct model model;

    bench_begin(&model.bench);
    bench_clear(&model.bench, STOP_POWER_UP, false);
    CHECK_EQUAL(ANSWER_NO_ARM, move(&model, 0, 0, true));
    CHECK_EQUAL(ANSWER_DONE, bench_arm_settings(&model.bench, &SETTINGS));
    CHECK_EQUAL(ANSWER_NO_ARM, move(&model, 0, 0, true));
    CHECK_EQUAL(ARM_UNKNOWN, report_of(&model).state);
    CHECK_EQUAL(0, arm_pulse(&model.bench.robot.arm, ARM_SHOULDER));
    begin(&model);
    CHECK_EQUAL(ARM_STANDING, report_of(&model).state);
    /* it shall stand where it stands: a quarter of 500 to 2500 us, in halves */
    CHECK_NEAR(2 * 1000, arm_pulse(&model.bench.robot.arm, ARM_SHOULDER), 2);
    CHECK_NEAR(2 * 1050, arm_pulse(&model.bench.robot.arm, ARM_ELBOW), 2);
}

static void hand_that_holds_something_stays_closed_after_a_start(void)
{
    struct model model;

    begin(&model);
    CHECK(!report_of(&model).is_hand_closed);
    CHECK_EQUAL(2000, arm_pulse(&model.bench.robot.arm, ARM_HAND));
    memset(&model.bench.robot.arm, 0, sizeof model.bench.robot.arm);
    model.load_mv = 1700;
    bench_arm_settings(&model.bench, &SETTINGS);
    live(&model, 20);
    CHECK(report_of(&model).is_hand_closed);
    CHECK_EQUAL(1200, report_of(&model).load_g);
    CHECK_EQUAL(4000, arm_pulse(&model.bench.robot.arm, ARM_HAND));
}

static void goes_anywhere_within_its_limits(void)
{
    struct model model;

    begin(&model);
    srand(1);
    for (int i = 0; i < 100; i++) {
        int32_t goal[ARM_JOINTS];

        for (int j = 0; j < ARM_JOINTS; j++) {
            const struct arm_joint_settings *joint = &SETTINGS.joints[j];
            int32_t span = joint->most_urad - joint->least_urad;

            goal[j] = i % 3 == 0 ? (rand() % 2 == 0 ? joint->least_urad : joint->most_urad)
                                 : joint->least_urad + (int32_t)(rand() / (RAND_MAX + 1.0) * span);
        }
        CHECK(go(&model, goal[0], goal[1], 10000) < 10000);
        CHECK_EQUAL(goal[0], model.bench.robot.arm.joints[0].at_urad);
        CHECK_EQUAL(goal[1], model.bench.robot.arm.joints[1].at_urad);
        CHECK_EQUAL(ARM_STANDING, report_of(&model).state);
    }
}

/* A trapezoid: 3 rad at 1.571 rad/s with 3.142 rad/s2 takes 3/1.571 + 1.571/3.142 = 2.41 s. */
static void is_as_fast_as_the_slower_joint_may(void)
{
    struct model model;
    uint32_t ms;

    begin(&model);
    go(&model, 0, 0, 10000);
    go(&model, -1500000, 100000, 10000);
    ms = go(&model, 1500000, -100000, 10000);
    CHECK(ms >= 2400 && ms <= 2480);
}

/* Both joints come from begin to end on the straight line. */
static void stays_on_its_line_and_tells_how_far_it_is(void)
{
    struct model model;
    uint8_t before = 0;

    begin(&model);
    go(&model, 0, 0, 10000);
    for (int i = 0; i < 500 && before != UINT8_MAX; i++) {
        move(&model, 2000000, -1000000, true);
        live(&model, 10);
        CHECK_NEAR(-model.bench.robot.arm.joints[0].at_urad / 2.0,
                   model.bench.robot.arm.joints[1].at_urad, 2);
        CHECK(report_of(&model).progress >= before);
        before = report_of(&model).progress;
    }
    CHECK_EQUAL(UINT8_MAX, before);
}

static uint32_t ms_to_stand_when_held(struct model *model, int32_t shoulder)
{
    uint32_t ms = 0;

    while (arm_is_moving(&model->bench.robot.arm) && ms < 2000) {
        move(model, shoulder, 0, false);
        live(model, 10);
        check_limits(model);
        ms += 10;
    }
    return ms;
}

/* From 1.571 rad/s with 3.142 rad/s2: 0.5 s. */
static void hold_and_silence_slow_it_down_and_it_goes_on(void)
{
    struct model model;

    begin(&model);
    go(&model, -2000000, 0, 10000);
    go(&model, 2000000, 0, 1000);
    CHECK_EQUAL(ARM_MOVING, report_of(&model).state);
    CHECK_NEAR(500, ms_to_stand_when_held(&model, 2000000), 30);
    CHECK(report_of(&model).progress != UINT8_MAX);
    go(&model, 2000000, 0, 1000);
    CHECK_EQUAL(ARM_MOVING, report_of(&model).state);
    for (int i = 0; i < 70; i++) { /* the arm is forgotten, and the robot is not */
        bench_velocity(&model.bench, 0, 0, 0);
        live(&model, 10);
        check_limits(&model);
    }
    CHECK_EQUAL(ARM_STANDING, report_of(&model).state);
    CHECK(report_of(&model).progress != UINT8_MAX);
    CHECK(go(&model, 2000000, 0, 5000) < 5000);
}

static void another_goal_is_obeyed_by_slowing_down_first(void)
{
    struct model model;
    int32_t at;

    begin(&model);
    go(&model, -2000000, 0, 10000);
    go(&model, 2000000, 0, 1000);
    at = model.bench.robot.arm.joints[0].at_urad;
    go(&model, -2000000, 1000000, 600);
    /* from 1.571 rad/s with 3.142 rad/s2: 0.39 rad, and not to the end of the line */
    CHECK(model.bench.robot.arm.joints[0].at_urad <= at + 410000);
    CHECK(go(&model, -2000000, 1000000, 10000) < 10000); /* within the limits all the way */
}

static void what_its_joints_cannot_do_is_refused(void)
{
    struct arm_settings settings = SETTINGS;
    struct model model;

    begin(&model);
    CHECK_EQUAL(ANSWER_DONE, move(&model, 2792527, -2600000, true));
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, move(&model, 2792528, 0, true));
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, move(&model, 0, -2600001, true));
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, move(&model, INT32_MIN, INT32_MAX, true));
    CHECK_EQUAL(2792527, model.bench.robot.arm.goal_urad[0]);

    settings.joints[1].most_urad = settings.joints[1].least_urad;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    settings = SETTINGS;
    settings.joints[0].least_urad = INT32_MIN;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    settings = SETTINGS;
    settings.joints[0].rate_mrad_s = ARM_MOST_RATE + 1;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    settings = SETTINGS;
    settings.joints[0].pulse_most_us = ARM_MOST_PULSE_US + 1;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    settings = SETTINGS;
    settings.joints[1].mv_most = settings.joints[1].mv_least;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    settings = SETTINGS;
    settings.mv_a_kg = 0;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_arm_settings(&model.bench, &settings));
    live(&model, 100);
    settings = SETTINGS;
    settings.mv_a_kg = 900;
    CHECK_EQUAL(ANSWER_MOVES, bench_arm_settings(&model.bench, &settings)); /* it moves */
    CHECK(arm_settings_are_same(&SETTINGS, &model.bench.robot.arm.settings));
}

/* At each bound, the sanitizers find an overflow. */
static void arm_at_the_bounds_of_its_settings_moves(void)
{
    static const uint16_t rates[] = {ARM_LEAST_RATE, ARM_MOST_RATE};
    static const uint16_t accelerations[] = {ARM_LEAST_RATE, UINT16_MAX};

    for (int i = 0; i < 4; i++) {
        struct arm_settings settings = SETTINGS;
        struct arm arm;

        for (int j = 0; j < ARM_JOINTS; j++) {
            settings.joints[j] = (struct arm_joint_settings){
                -ARM_MOST_ANGLE_URAD,    ARM_MOST_ANGLE_URAD, rates[i & 1], accelerations[i >> 1],
                ARM_MOST_PULSE_US,       ARM_LEAST_PULSE_US,  ARM_MOST_MV,  0};
        }
        CHECK(arm_settings_are_good(&settings));
        arm_begin(&arm, &settings);
        for (int channel = 0; channel < ARM_CHANNELS; channel++) {
            arm_measure(&arm, (enum arm_channel)channel, UINT16_MAX);
        }
        CHECK_EQUAL(-ARM_MOST_ANGLE_URAD, arm.joints[0].at_urad);
        for (uint32_t ms = 0; ms < 20000; ms += 10) {
            static const struct arm_goal far = {{ARM_MOST_ANGLE_URAD, -ARM_MOST_ANGLE_URAD + 1},
                                                true, true};
            CHECK_EQUAL(ANSWER_DONE, arm_move(&arm, &far, ms));
            arm.joints[0].measured_urad = arm.joints[0].at_urad;
            arm_tick(&arm, ms, true);
            CHECK(arm_pulse(&arm, ARM_SHOULDER) >= 2 * ARM_LEAST_PULSE_US &&
                  arm_pulse(&arm, ARM_SHOULDER) <= 2 * ARM_MOST_PULSE_US);
        }
        CHECK((arm_report_of(&arm).progress == UINT8_MAX) == (i == 3));
    }
}

static void every_stop_stops_it_at_once_and_only_a_clear_lets_it_go_on(void)
{
    struct model model;
    int32_t at;

    begin(&model);
    go(&model, -2000000, 0, 10000);
    go(&model, 2000000, 0, 1000);
    model.bench.inputs.is_stop_pressed = true;
    bench_live(&model.bench, 1);
    at = model.bench.robot.arm.joints[0].at_urad;
    CHECK(!arm_is_moving(&model.bench.robot.arm));
    for (int i = 0; i < 10; i++) {
        CHECK_EQUAL(ANSWER_STOPPED, move(&model, 2000000, 0, true));
        live(&model, 10);
    }
    CHECK_EQUAL(at, model.bench.robot.arm.joints[0].at_urad);
    CHECK(report_of(&model).is_hand_closed); /* what it holds is held */
    model.bench.inputs.is_stop_pressed = false;
    live(&model, 10);
    CHECK_EQUAL(ANSWER_NOT_CLEARED, bench_clear(&model.bench, STOP_SWITCH, false));
    CHECK_EQUAL(ANSWER_DONE, bench_clear(&model.bench, STOP_SWITCH, true));
    live(&model, 100);
    CHECK_EQUAL(at, model.bench.robot.arm.joints[0].at_urad); /* nobody has said so anew */
    model.rate[0] = 0;
    model.before[0] = at;
    CHECK(go(&model, 2000000, 0, 5000) < 5000);
}

static void cut_link_stops_it(void)
{
    struct model model;

    begin(&model);
    go(&model, -2000000, 0, 10000);
    go(&model, 2000000, 0, 1000);
    live(&model, 180); /* the last frame was 20 ms ago */
    CHECK(!arm_is_moving(&model.bench.robot.arm));
    CHECK_EQUAL(STOP_LINK, bench_status(&model.bench).stop_reasons);
}

static void stuck_joint_is_relieved_and_told(void)
{
    struct model model;

    begin(&model);
    go(&model, 0, 0, 10000);
    model.is_stuck = true;
    for (int i = 0; i < 200; i++) { /* what it shall do jumps to what it does */
        move(&model, 2000000, 0, true);
        live(&model, 10);
    }
    CHECK_EQUAL(ARM_STALLED, report_of(&model).state);
    CHECK_NEAR(0, model.bench.robot.arm.joints[0].at_urad, 10000);
    model.is_stuck = false;
    model.before[0] = model.bench.robot.arm.joints[0].at_urad;
    model.rate[0] = 0;
    go(&model, 2000000, 0, 500);
    CHECK_EQUAL(ARM_STALLED, report_of(&model).state); /* the same goal */
    CHECK_NEAR(0, report_of(&model).angle_urad[0], 10000);
    CHECK(go(&model, 1000000, 0, 5000) < 5000);
    CHECK_EQUAL(ARM_STANDING, report_of(&model).state);
}

static void nothing_drives_while_it_moves_and_it_does_not_move_while_something_drives(void)
{
    static const struct segment metre = {250000, 0, 4000000};
    struct model model;

    begin(&model);
    go(&model, 0, 0, 10000);
    go(&model, 2000000, 0, 500);
    CHECK_EQUAL(ANSWER_MOVES, bench_velocity(&model.bench, 100000, 0, 0));
    CHECK_EQUAL(ANSWER_MOVES, bench_path(&model.bench, 1, &metre, 1));
    CHECK_EQUAL(ANSWER_DONE, bench_velocity(&model.bench, 0, 0, 0));
    CHECK(go(&model, 2000000, 0, 5000) < 5000);
    CHECK_EQUAL(ANSWER_DONE, bench_path(&model.bench, 1, &metre, 1));
    for (int i = 0; i < 50; i++) {
        bench_segments(&model.bench, 1, 1, true, NULL, 0);
        live(&model, 20);
    }
    CHECK_EQUAL(ANSWER_MOVES, move(&model, 0, 0, true));
    CHECK_EQUAL(2000000, model.bench.robot.arm.goal_urad[0]);
    bench_live_polled(&model.bench, 8000);
    CHECK_EQUAL(ROBOT_PATH_STANDING, bench_status(&model.bench).state);
    CHECK(go(&model, 0, 0, 5000) < 5000);
}

void arm_tests(void)
{
    there_is_no_arm_until_its_settings_came_and_it_was_measured();
    hand_that_holds_something_stays_closed_after_a_start();
    goes_anywhere_within_its_limits();
    is_as_fast_as_the_slower_joint_may();
    stays_on_its_line_and_tells_how_far_it_is();
    hold_and_silence_slow_it_down_and_it_goes_on();
    another_goal_is_obeyed_by_slowing_down_first();
    what_its_joints_cannot_do_is_refused();
    arm_at_the_bounds_of_its_settings_moves();
    every_stop_stops_it_at_once_and_only_a_clear_lets_it_go_on();
    cut_link_stops_it();
    stuck_joint_is_relieved_and_told();
    nothing_drives_while_it_moves_and_it_does_not_move_while_something_drives();
}
