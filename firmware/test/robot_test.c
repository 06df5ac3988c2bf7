/* The whole robot over its modelled drive and motors, in time that only the test moves. */
#include <math.h>
#include <string.h>

#include "bench.h"
#include "check.h"
#include "tests.h"

static const double UM = 1e6; /* a metre */
static const double STOPPED_M_S = 0.010; /* at the rim, as the daemon takes it */

/* A quarter circle to the left, radius 0.25 m: pi/2 at 1 rad/s. And a metre. */
static const struct segment QUARTER_AND_METRE[] = {{250000, 1000000, 1570796}, {250000, 0, 4000000}};

static const struct segment METRE = {250000, 0, 4000000};

static void drives_arc_straight_and_stop(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    CHECK_EQUAL(ANSWER_DONE, bench_path(&bench, 1, QUARTER_AND_METRE, 2));
    bench_live_polled(&bench, 9000);

    CHECK_EQUAL(ROBOT_PATH_STANDING, bench_status(&bench).state);
    CHECK_NEAR(0.25, bench.rig.x, 0.005);
    CHECK_NEAR(0.25 + 1.0, bench.rig.y, 0.005);
    CHECK_NEAR(M_PI / 2, bench.rig.theta, 0.01);
    CHECK_NEAR(bench.rig.x * UM, bench_status(&bench).x_um, 2000);
    CHECK_NEAR(bench.rig.y * UM, bench_status(&bench).y_um, 2000);
    CHECK_NEAR(bench.rig.theta * UM, bench_status(&bench).heading_urad, 1000);
    CHECK_EQUAL(2, bench_status(&bench).segments_driven);
}

static void follows_a_velocity(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    for (int i = 0; i < 100; i++) {
        bench_velocity(&bench, 200000, -100000, 500000);
        bench_live(&bench, 20);
    }
    /* v2 = vy + R w = -0.1 + 0.1 * 0.5 = -0.05 m/s; 2808 counts for 0.2513 m */
    CHECK_NEAR(-0.05 * 2808 / (2 * M_PI * 0.04), bench.rig.motors[1].rate, 30);
    CHECK_EQUAL(ROBOT_DRIVING, bench_status(&bench).state);
}

static double seconds_to_stand(struct bench *bench, uint16_t ms)
{
    double last_motion = 0;

    for (uint16_t i = 0; i < ms; i++) {
        bench_live(bench, 1);
        if (rig_fastest_rim(&bench->rig) > STOPPED_M_S) {
            last_motion = (i + 1) / 1000.0;
        }
    }
    return last_motion;
}

static void drive_fast(struct bench *bench)
{
    bench_begin(bench);
    bench_clear(bench, STOP_POWER_UP, false);
    for (int i = 0; i < 100; i++) {
        bench_velocity(bench, 500000, 0, 0);
        bench_live(bench, 10);
    }
    CHECK(rig_fastest_rim(&bench->rig) > 0.4);
}

static void silence_stops_the_wheels_in_250_ms(void)
{
    struct bench bench;

    drive_fast(&bench);
    /* 10 ms have passed since the last frame */
    CHECK(seconds_to_stand(&bench, 1000) <= 0.240);
    CHECK_EQUAL(STOP_LINK, bench_status(&bench).stop_reasons);
    CHECK_EQUAL(ANSWER_DONE, bench_clear(&bench, STOP_LINK, false));
    CHECK_EQUAL(0, bench_status(&bench).stop_reasons);
}

static void edge_stops_in_50_ms_until_a_person_says_otherwise(void)
{
    struct bench bench;

    drive_fast(&bench);
    bench.inputs.floor_mv[2] = 999;
    CHECK(seconds_to_stand(&bench, 150) <= 0.050);
    CHECK_EQUAL(STOP_EDGE, bench_status(&bench).stop_reasons);
    CHECK_EQUAL(ANSWER_NOT_CLEARED, bench_clear(&bench, STOP_EDGE, true));
    bench.inputs.floor_mv[2] = 1000;
    bench_live_polled(&bench, 20);
    CHECK_EQUAL(ANSWER_NOT_CLEARED, bench_clear(&bench, STOP_EDGE, false));
    CHECK_EQUAL(STOP_EDGE, bench_status(&bench).stop_reasons);
    CHECK_EQUAL(ANSWER_DONE, bench_clear(&bench, STOP_EDGE, true));
    CHECK_EQUAL(0, bench_status(&bench).stop_reasons);
}

static void heat_and_switch_stop_in_50_ms(void)
{
    struct bench bench;

    drive_fast(&bench);
    bench.inputs.is_hot = true;
    CHECK(seconds_to_stand(&bench, 150) <= 0.050);
    CHECK_EQUAL(STOP_HEAT, bench_status(&bench).stop_reasons);
    drive_fast(&bench);
    bench.inputs.is_stop_pressed = true;
    CHECK(seconds_to_stand(&bench, 150) <= 0.050);
    CHECK_EQUAL(STOP_SWITCH, bench_status(&bench).stop_reasons);
}

/* Deterministic: the same numbers every time (xorshift32); -1 to 1. */
static double random_share(void)
{
    static uint32_t state = 2463534242U;

    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state / 2147483648.0 - 1;
}

/* Any twist that a command may have, slow ones too; the wheels are slowed to what they may. */
static void drive_anyhow(struct bench *bench, double load)
{
    double share = fabs(random_share());
    int32_t vx = (int32_t)(share * random_share() * TWIST_SPEED_LIMIT_UM_S);
    int32_t vy = (int32_t)(share * random_share() * TWIST_SPEED_LIMIT_UM_S);
    int32_t w = (int32_t)(share * random_share() * TWIST_TURN_LIMIT_URAD_S);

    bench_begin(bench);
    bench_clear(bench, STOP_POWER_UP, false);
    for (int i = 0; i < RIG_WHEELS; i++) {
        bench->rig.motors[i].load = load;
    }
    for (int i = 0; i < 100; i++) {
        bench_velocity(bench, vx, vy, w);
        bench_live(bench, 10);
    }
    bench_live(bench, (uint32_t)(10 * fabs(random_share())));
}

/* The load: up to 0.4 of the robot's own mass. */
static void every_twist_is_stopped_in_50_ms_with_and_without_load(void)
{
    static const double loads[] = {0, 0.2, 0.4};
    double fastest = 0;

    for (int i = 0; i < 2000; i++) {
        struct bench bench;

        drive_anyhow(&bench, loads[i % 3]);
        fastest = fmax(fastest, rig_fastest_rim(&bench.rig));
        bench.inputs.is_stop_pressed = true;
        CHECK(seconds_to_stand(&bench, 150) <= 0.050);
    }
    /* 150 turns a minute: 0.628 m/s */
    CHECK_NEAR(0.628, fastest, 0.02);
}

static void low_battery_stops(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    bench.inputs.battery_mv = 13000;
    bench_live_polled(&bench, 900);
    CHECK_EQUAL(0, bench_status(&bench).stop_reasons);
    bench_live_polled(&bench, 300);
    CHECK_EQUAL(STOP_BATTERY, bench_status(&bench).stop_reasons);
}

static void blocked_wheel_is_a_stall(void)
{
    struct bench bench;

    drive_fast(&bench);
    bench.rig.motors[2].is_blocked = true;
    for (int i = 0; i < 70; i++) {
        bench_velocity(&bench, 300000, 0, 0);
        bench_live(&bench, 10);
    }
    CHECK_EQUAL(STOP_STALL, bench_status(&bench).stop_reasons & STOP_STALL);
    CHECK(rig_fastest_rim(&bench.rig) < STOPPED_M_S);
    CHECK_EQUAL(ANSWER_STOPPED, bench_velocity(&bench, 300000, 0, 0));
}

static void reversed_wheel_is_no_stall(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    for (int i = 0; i < 300; i++) {
        /* there and back in 400 ms: over some 300 ms of these it comes to where it was */
        bench_velocity(&bench, 0, 0, (i + 5) / 20 % 2 == 0 ? 1500000 : -1500000);
        bench_live(&bench, 10);
    }
    CHECK_EQUAL(0, bench_status(&bench).stop_reasons);
}

static void nothing_is_driven_after_power_up(void)
{
    struct bench bench;

    bench_begin(&bench);
    CHECK_EQUAL(ANSWER_STOPPED, bench_velocity(&bench, 100000, 0, 0));
    CHECK_EQUAL(ANSWER_STOPPED, bench_path(&bench, 1, &METRE, 1));
    bench_live_polled(&bench, 300);
    CHECK_EQUAL(0, bench_status(&bench).counts[0]);
    CHECK_EQUAL(ROBOT_STOPPED, bench_status(&bench).state);
}

static void begin_path(struct bench *bench)
{
    bench_begin(bench);
    bench_clear(bench, STOP_POWER_UP, false);
    CHECK_EQUAL(ANSWER_DONE, bench_path(bench, 7, &METRE, 1));
}

static void command_that_comes_again_is_done_once(void)
{
    struct bench bench;

    begin_path(&bench);
    for (int i = 0; i < 3; i++) {
        /* under the same sequence, and the same segments under another one */
        bench_segments(&bench, 7, 1, true, QUARTER_AND_METRE, 2);
        bench.sequence--;
        bench_segments(&bench, 7, 1, true, QUARTER_AND_METRE, 2);
        CHECK_EQUAL(ANSWER_DONE, bench_path(&bench, 7, &METRE, 1));
        CHECK_EQUAL(13, bench_status(&bench).queue_free);
        bench_live_polled(&bench, 1000);
    }
    CHECK_EQUAL(ANSWER_DONE, bench_segments(&bench, 7, 2, true, QUARTER_AND_METRE, 2));
    CHECK_EQUAL(12, bench_status(&bench).queue_free); /* one of the two is new */
}

static void segments_after_a_gap_are_not_driven(void)
{
    struct bench bench;

    begin_path(&bench);
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_segments(&bench, 7, 2, true, &METRE, 1));
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_segments(&bench, 8, 1, true, &METRE, 1));
    CHECK_EQUAL(15, bench_status(&bench).queue_free);
    bench_live_polled(&bench, 8000);
    CHECK_NEAR(1, bench.rig.x, 0.005);
    CHECK_EQUAL(ROBOT_PATH_STANDING, bench_status(&bench).state);
}

/* A queue that has run out goes on from there when the next segments come. */
static void path_goes_on_after_its_queue_was_empty(void)
{
    struct bench bench;

    begin_path(&bench);
    for (uint16_t first = 1; first <= 3; first++) {
        bench_live_polled(&bench, 6000);
        CHECK_NEAR(first, bench.rig.x, 0.005);
        CHECK_EQUAL(16, bench_status(&bench).queue_free);
        CHECK_EQUAL(ANSWER_DONE, bench_segments(&bench, 7, first, true, &METRE, 1));
    }
}

static void cut_link_stops_on_the_path_and_drops_it(void)
{
    struct bench bench;

    begin_path(&bench);
    bench_segments(&bench, 7, 1, true, &METRE, 1);
    bench_live_polled(&bench, 2000);
    /* the last poll was 20 ms ago */
    CHECK(seconds_to_stand(&bench, 1000) <= 0.230);
    CHECK_EQUAL(STOP_LINK, bench_status(&bench).stop_reasons);
    CHECK_EQUAL(16, bench_status(&bench).queue_free);
    bench_clear(&bench, STOP_LINK, false);
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_path(&bench, 7, &METRE, 1));
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_segments(&bench, 7, 0, true, &METRE, 1));
    CHECK(seconds_to_stand(&bench, 150) == 0);
    CHECK_EQUAL(ANSWER_DONE, bench_path(&bench, 8, &METRE, 1));
}

static void queue_takes_sixteen_segments(void)
{
    static const struct segment piece = {100000, 0, 500000};
    struct bench bench;

    bench_begin(&bench);
    bench_clear(&bench, STOP_POWER_UP, false);
    CHECK_EQUAL(ANSWER_DONE, bench_path(&bench, 1, &piece, 1));
    for (uint16_t i = 1; i < 16; i++) {
        CHECK_EQUAL(ANSWER_DONE, bench_segments(&bench, 1, i, true, &piece, 1));
    }
    CHECK_EQUAL(ANSWER_QUEUE_FULL, bench_segments(&bench, 1, 16, true, &piece, 1));
    bench_live_polled(&bench, 10000);
    /* 16 segments of 0.05 m */
    CHECK_NEAR(0.8, bench.rig.x, 0.005);
    CHECK_EQUAL(16, bench_status(&bench).segments_driven);
}

/* From 0.25 m/s with 0.5 m/s2: 0.5 s, 0.063 m. */
static void held_robot_slows_down_on_its_path_and_goes_on(void)
{
    struct bench bench;
    double held;

    begin_path(&bench);
    bench_live_polled(&bench, 2000);
    held = bench.rig.x;
    bench_segments(&bench, 7, 1, false, NULL, 0);
    bench_live_polled(&bench, 1500);
    CHECK_NEAR(held + 0.063, bench.rig.x, 0.012);
    CHECK_EQUAL(ROBOT_PATH_STANDING, bench_status(&bench).state);
    CHECK_EQUAL(0, bench_status(&bench).pace);
    CHECK(rig_fastest_rim(&bench.rig) < STOPPED_M_S);
    bench_segments(&bench, 7, 1, true, NULL, 0);
    bench_live_polled(&bench, 6000);
    CHECK_NEAR(1, bench.rig.x, 0.005);
}

static void velocity_drops_the_path(void)
{
    struct bench bench;

    begin_path(&bench);
    bench_live_polled(&bench, 1000);
    bench_velocity(&bench, 0, 0, 0);
    CHECK_EQUAL(16, bench_status(&bench).queue_free);
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_segments(&bench, 7, 1, true, &METRE, 1));
    CHECK_EQUAL(ANSWER_NOT_ON_PATH, bench_path(&bench, 7, &METRE, 1));
    bench_live_polled(&bench, 500);
    CHECK(rig_fastest_rim(&bench.rig) < STOPPED_M_S);
}

static void each_floor_sensor_has_its_threshold(void)
{
    struct settings settings = settings_default();

    for (int i = 0; i < BODY_FLOOR_SENSORS; i++) {
        struct bench bench;

        bench_begin(&bench);
        settings.floor_mv[i] = (uint16_t)(2000 + 100 * i);
        CHECK_EQUAL(ANSWER_DONE, bench_settings(&bench, &settings));
        for (int sensor = 0; sensor < BODY_FLOOR_SENSORS; sensor++) {
            bench.inputs.floor_mv[sensor] = settings.floor_mv[sensor];
        }
        bench_live_polled(&bench, 20);
        CHECK_EQUAL(0, bench_status(&bench).missing_floor);
        bench.inputs.floor_mv[i]--;
        bench_live_polled(&bench, 20);
        CHECK_EQUAL(1 << i, bench_status(&bench).missing_floor);
    }
}

static void settings_are_taken_within_their_bounds_by_a_robot_that_stands(void)
{
    struct settings settings = settings_default();
    struct bench bench;

    drive_fast(&bench);
    CHECK_EQUAL(ANSWER_DONE, bench_settings(&bench, &settings)); /* it has them */
    settings.wheel_radius_um = 50000;
    CHECK_EQUAL(ANSWER_MOVES, bench_settings(&bench, &settings));
    bench_live_polled(&bench, 1000);
    CHECK_EQUAL(ANSWER_DONE, bench_settings(&bench, &settings));
    settings.wheel_radius_um = SETTINGS_MOST_WHEEL_RADIUS_UM + 1;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_settings(&bench, &settings));
    settings.wheel_radius_um = 40000;
    settings.centre_to_wheel_um = SETTINGS_LEAST_CENTRE_TO_WHEEL_UM - 1;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_settings(&bench, &settings));
    settings.centre_to_wheel_um = 100000;
    settings.floor_mv[4] = SETTINGS_MOST_FLOOR_MV + 1;
    CHECK_EQUAL(ANSWER_OUT_OF_RANGE, bench_settings(&bench, &settings));
    CHECK_EQUAL(50000, bench.robot.settings.wheel_radius_um);
}

static void switches_and_temperature_are_told(void)
{
    struct bench bench;

    bench_begin(&bench);
    bench.inputs.temperature = 84;
    bench.inputs.pressed_switches = 0x5;
    bench_live_polled(&bench, 100);
    CHECK_EQUAL(84, bench_status(&bench).temperature);
    CHECK_EQUAL(0x5, bench_status(&bench).pressed_switches);
    CHECK_EQUAL(0, bench_status(&bench).stop_reasons & STOP_HEAT);
    CHECK(!bench.robot.shows_measurements);
    bench.inputs.pressed_switches = 0;
    bench.inputs.temperature = 85;
    bench_live_polled(&bench, 100);
    CHECK(bench.robot.shows_measurements);
    CHECK_EQUAL(STOP_HEAT, bench_status(&bench).stop_reasons & STOP_HEAT);
}

void robot_tests(void)
{
    drives_arc_straight_and_stop();
    follows_a_velocity();
    silence_stops_the_wheels_in_250_ms();
    edge_stops_in_50_ms_until_a_person_says_otherwise();
    heat_and_switch_stop_in_50_ms();
    every_twist_is_stopped_in_50_ms_with_and_without_load();
    low_battery_stops();
    blocked_wheel_is_a_stall();
    reversed_wheel_is_no_stall();
    nothing_is_driven_after_power_up();
    command_that_comes_again_is_done_once();
    queue_takes_sixteen_segments();
    segments_after_a_gap_are_not_driven();
    path_goes_on_after_its_queue_was_empty();
    cut_link_stops_on_the_path_and_drops_it();
    held_robot_slows_down_on_its_path_and_goes_on();
    velocity_drops_the_path();
    each_floor_sensor_has_its_threshold();
    settings_are_taken_within_their_bounds_by_a_robot_that_stands();
    switches_and_temperature_are_told();
}
