/* The integer kinematics against the same formulas in floating point: the stated error bounds. */
#include <math.h>
#include <stdlib.h>

#include "angle.h"
#include "check.h"
#include "odometry.h"
#include "square_root.h"
#include "tests.h"
#include "wheel.h"

/* The robot that nobody has measured, and each bound of what may be measured. */
static const struct settings ROBOTS[] = {
    {SETTINGS_WHEEL_RADIUS_UM, SETTINGS_CENTRE_TO_WHEEL_UM, {0}},
    {SETTINGS_LEAST_WHEEL_RADIUS_UM, SETTINGS_LEAST_CENTRE_TO_WHEEL_UM, {0}},
    {SETTINGS_LEAST_WHEEL_RADIUS_UM, SETTINGS_MOST_CENTRE_TO_WHEEL_UM, {0}},
    {SETTINGS_MOST_WHEEL_RADIUS_UM, SETTINGS_LEAST_CENTRE_TO_WHEEL_UM, {0}},
    {SETTINGS_MOST_WHEEL_RADIUS_UM, SETTINGS_MOST_CENTRE_TO_WHEEL_UM, {0}},
};

static const struct settings *robot = ROBOTS;

static double counts_a_metre(void)
{
    return 2808 / (2 * M_PI * robot->wheel_radius_um * 1e-6);
}

static void sine_is_off_by_at_most_6e_5(void)
{
    double worst = 0;

    for (uint32_t i = 0; i < 100000; i++) {
        uint32_t angle = i * 42949U;
        double radians = angle * (2 * M_PI / 4294967296.0);

        worst = fmax(worst, fabs(sin(radians) - angle_sin_q15(angle) / 32768.0));
        worst = fmax(worst, fabs(cos(radians) - angle_cos_q15(angle) / 32768.0));
    }
    CHECK_NEAR(0, worst, 6e-5);
}

static void root_is_the_whole_part(void)
{
    for (uint32_t i = 0; i < 65536; i++) {
        CHECK_EQUAL(i, square_root(i * i));
        CHECK_EQUAL(i, square_root(i * i + 2 * i)); /* (i + 1)^2 - 1 */
    }
}

static double forward(double vx, double vy, double w, int wheel)
{
    double R = robot->centre_to_wheel_um * 1e-6;

    switch (wheel) {
    case 0:
        return sqrt(3) / 2 * vx - vy / 2 + R * w;
    case 1:
        return vy + R * w;
    default:
        return -sqrt(3) / 2 * vx - vy / 2 + R * w;
    }
}

static void wheel_rates_are_off_by_at_most_one_unit(void)
{
    struct wheel_scale scale = wheel_scale_of(robot);

    for (int32_t vx = -1000000; vx <= 1000000; vx += 76923) {
        for (int32_t vy = -1000000; vy <= 1000000; vy += 90909) {
            for (int32_t w = -10000000; w <= 10000000; w += 769231) {
                struct twist twist = {vx, vy, w};
                struct wheel_rates rates;

                wheel_rates_from_twist(&scale, &twist, &rates);
                for (int i = 0; i < BODY_WHEELS; i++) {
                    double exact = forward(vx, vy, w, i) * 1e-6 * counts_a_metre() * 256;

                    CHECK_NEAR(exact, rates.q8[i], 1 + 2e-7 * fabs(exact));
                }
            }
        }
    }
}

static void limit_slows_all_wheels_alike(void)
{
    struct wheel_rates rates = {{2 * WHEEL_MAX_RATE_Q8, -WHEEL_MAX_RATE_Q8, WHEEL_MAX_RATE_Q8 / 2}};

    wheel_rates_limit(&rates);
    CHECK_EQUAL(WHEEL_MAX_RATE_Q8, rates.q8[0]);
    CHECK_EQUAL(-WHEEL_MAX_RATE_Q8 / 2, rates.q8[1]);
    CHECK_EQUAL(WHEEL_MAX_RATE_Q8 / 4, rates.q8[2]);
}

/* Drives a curve by counts, in periods of 10 ms, and compares with the exact curve. */
static void odometry_follows_a_curve(double vx, double vy, double w, double seconds)
{
    static const int32_t near_wrap = INT32_MAX - 1000;
    int32_t counts[BODY_WHEELS] = {near_wrap, near_wrap, near_wrap};
    struct odometry odometry;
    double sine = sin(w * seconds);
    double cosine = cos(w * seconds);
    double x = (vx * sine - vy * (1 - cosine)) / w;
    double y = (vx * (1 - cosine) + vy * sine) / w;
    double length = hypot(vx, vy) * seconds;

    odometry_begin(&odometry, counts, robot);
    for (int step = 1; step <= (int)(seconds * 100 + 0.5); step++) {
        for (int i = 0; i < BODY_WHEELS; i++) {
            double turned = forward(vx, vy, w, i) * step / 100 * counts_a_metre();

            counts[i] = (int32_t)((uint32_t)near_wrap + (uint32_t)(int32_t)floor(turned));
        }
        odometry_update(&odometry, counts);
    }
    /* a count is 0.09 mm and 0.3 mrad; curve and rounding as pose.h says */
    CHECK_NEAR(x * 1e6, pose_um(odometry.pose.x_um_q16), 300 + 5e-4 * length * 1e6);
    CHECK_NEAR(y * 1e6, pose_um(odometry.pose.y_um_q16), 300 + 5e-4 * length * 1e6);
    /* three wheels, a count each: 0.9 mrad where r/R is 0.4 */
    CHECK_NEAR(remainder(w * seconds, 2 * M_PI) * 1e6, angle_urad(odometry.pose.heading),
               2500.0 * robot->wheel_radius_um / robot->centre_to_wheel_um);
}

/* Counters that were set back, say; the sanitizers watch the products. */
static void jump_of_the_counters_is_cut(void)
{
    int32_t counts[BODY_WHEELS] = {0, 0, 0};
    struct odometry odometry;

    odometry_begin(&odometry, counts, robot);
    counts[0] = INT32_MAX;
    counts[1] = INT32_MIN;
    odometry_update(&odometry, counts);
    CHECK(fabs(pose_um(odometry.pose.x_um_q16) * 1e-6) < 0.5);
    CHECK(fabs(pose_um(odometry.pose.y_um_q16) * 1e-6) < 0.5);
}

static void other_wheels_leave_place_and_heading(void)
{
    int32_t counts[BODY_WHEELS] = {500, 700, 900};
    struct odometry odometry;
    struct pose before;

    odometry_begin(&odometry, (int32_t[BODY_WHEELS]){0, 0, 0}, robot);
    odometry_update(&odometry, counts);
    before = odometry.pose;
    odometry_set_wheels(&odometry, &ROBOTS[3]);
    odometry_update(&odometry, counts);
    CHECK_EQUAL(before.x_um_q16, odometry.pose.x_um_q16);
    CHECK_EQUAL(before.y_um_q16, odometry.pose.y_um_q16);
    CHECK_EQUAL(before.heading, odometry.pose.heading);
}

void kinematics_tests(void)
{
    sine_is_off_by_at_most_6e_5();
    root_is_the_whole_part();
    limit_slows_all_wheels_alike();
    for (unsigned i = 0; i < sizeof ROBOTS / sizeof ROBOTS[0]; i++) {
        robot = &ROBOTS[i];
        wheel_rates_are_off_by_at_most_one_unit();
        odometry_follows_a_curve(0.2, -0.1, 0.7, 20);
        jump_of_the_counters_is_cut();
    }
    robot = ROBOTS;
    other_wheels_leave_place_and_heading();
    odometry_follows_a_curve(0.25, 0, 1, 1.57);
    odometry_follows_a_curve(0.25, 0, -1, 40);
    odometry_follows_a_curve(0.2, -0.1, 0.7, 20);
    odometry_follows_a_curve(0.5, 0, 3.5, 10);
    odometry_follows_a_curve(0.25, 0, 1e-6, 40);
}
