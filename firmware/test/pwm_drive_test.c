/* The PWM drive over modelled motors. */
#include <string.h>

#include "bench_drive.h"
#include "check.h"
#include "drive.h"
#include "tests.h"

static struct rig rig;

static void begin(void)
{
    memset(&rig, 0, sizeof rig);
    bench_drive_begin(&rig);
    drive_begin();
}

static void live(unsigned ms)
{
    static double seconds;

    for (seconds += ms / 1000.0; seconds > 0; seconds -= BENCH_DRIVE_SAMPLE) {
        bench_drive_sample();
    }
}

static void turn_for(const struct wheel_rates *rates, int periods)
{
    int32_t counts[BODY_WHEELS];

    for (int i = 0; i < periods; i++) {
        drive_read_counts(counts);
        drive_turn(rates);
        live(DRIVE_PERIOD_MS);
    }
}

/* counts a second times 2^8 */
static const struct wheel_rates RATES = {{2800 * 256, -1000 * 256, 0}};

static void wheels_turn_as_told(void)
{
    begin();
    turn_for(&RATES, 300);
    CHECK_NEAR(2800, rig.motors[0].rate, 50);
    CHECK_NEAR(-1000, rig.motors[1].rate, 50);
    CHECK_NEAR(0, rig.motors[2].rate, 1);
    /* 3 s; the position follows with its own lag */
    CHECK_NEAR(3 * 2800, rig.motors[0].angle, 60);
    CHECK_NEAR(3 * -1000, rig.motors[1].angle, 60);
}

static void stop_stops_in_50_ms(void)
{
    begin();
    turn_for(&RATES, 300);
    for (int ms = 0; ms < 50; ms++) {
        drive_stop();
        live(1);
    }
    CHECK_NEAR(0, rig.motors[0].rate, 112); /* 10 mm/s */
    CHECK_NEAR(0, rig.motors[1].rate, 112);
}

static void blocked_wheel_does_not_leap_when_it_is_freed(void)
{
    begin();
    rig.motors[0].is_blocked = true;
    turn_for(&RATES, 500);
    rig.motors[0].is_blocked = false;
    turn_for(&RATES, 100);
    /* a second, and what full voltage had answered */
    CHECK(rig.motors[0].angle < 2800 + 728);
}

void pwm_drive_tests(void)
{
    wheels_turn_as_told();
    stop_stops_in_50_ms();
    blocked_wheel_does_not_leap_when_it_is_freed();
}
