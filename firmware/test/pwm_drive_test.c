/* The PWM drive over modelled motors. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "drive.h"
#include "motor.h"
#include "pwm_bus.h"

static struct motor motors[BODY_WHEELS];
static int16_t duties[BODY_WHEELS];

void pwm_bus_begin(void)
{
    memset(motors, 0, sizeof motors);
    memset(duties, 0, sizeof duties);
}

void pwm_bus_drive(uint8_t wheel, int16_t duty)
{
    CHECK(duty >= -PWM_FULL && duty <= PWM_FULL);
    duties[wheel] = duty;
}

void pwm_bus_counts(int32_t counts[BODY_WHEELS])
{
    for (int i = 0; i < BODY_WHEELS; i++) {
        counts[i] = (int32_t)floor(motors[i].angle);
    }
}

static void live(void)
{
    for (int ms = 0; ms < DRIVE_PERIOD_MS; ms++) {
        for (int i = 0; i < BODY_WHEELS; i++) {
            motor_turn(&motors[i], duties[i] / (double)PWM_FULL, 0.001);
        }
    }
}

static void turn_for(const struct wheel_rates *rates, int periods)
{
    int32_t counts[BODY_WHEELS];

    for (int i = 0; i < periods; i++) {
        drive_read_counts(counts);
        drive_turn(rates);
        live();
    }
}

/* counts a second times 2^8 */
static const struct wheel_rates RATES = {{2800 * 256, -1000 * 256, 0}};

static void wheels_turn_as_told(void)
{
    drive_begin();
    turn_for(&RATES, 300);
    CHECK_NEAR(2800, motors[0].rate, 50);
    CHECK_NEAR(-1000, motors[1].rate, 50);
    CHECK_NEAR(0, motors[2].rate, 1);
    /* 3 s; the position follows with its own lag */
    CHECK_NEAR(3 * 2800, motors[0].angle, 60);
    CHECK_NEAR(3 * -1000, motors[1].angle, 60);
}

static void stop_stops_in_a_tenth_of_a_second(void)
{
    int32_t counts[BODY_WHEELS];

    drive_begin();
    turn_for(&RATES, 300);
    for (int i = 0; i < 10; i++) {
        drive_read_counts(counts);
        drive_stop();
        live();
    }
    CHECK_NEAR(0, motors[0].rate, 112); /* 10 mm/s */
    drive_read_counts(counts);
    drive_stop();
    CHECK_NEAR(0, duties[0], 10);
}

static void blocked_wheel_does_not_leap_when_it_is_freed(void)
{
    drive_begin();
    motors[0].is_blocked = true;
    turn_for(&RATES, 500);
    motors[0].is_blocked = false;
    turn_for(&RATES, 100);
    /* a second, and what full voltage had answered */
    CHECK(motors[0].angle < 2800 + 728);
}

int main(void)
{
    wheels_turn_as_told();
    stop_stops_in_a_tenth_of_a_second();
    blocked_wheel_does_not_leap_when_it_is_freed();
    return check_result();
}
