/*
 * A drive without motion controllers: the motor's voltage fed forward in proportion to the rate,
 * and more or less of it in proportion to the error of a position that moves on with the rate.
 */
#include <string.h>

#include "brake.h"
#include "drive.h"
#include "pwm_bus.h"

/* Counts a second, by full voltage. */
static const int32_t FULL_RATE = WHEEL_RATED_Q8 / 256;

/* PWM steps for a count a second, times 2^16: what keeps the wheel turning. */
static const int32_t FORWARD_Q16 = INT32_C(65536) * PWM_FULL / (WHEEL_RATED_Q8 / 256);

/* PWM steps a count, times 2^8: with 0.35 the wheel follows with a time constant of 70 ms. */
static const int32_t GAIN_Q8 = 90;

/* Counts a second, 30 mm/s at the rim: its friction stops a slower wheel as soon. */
static const int32_t SLOWEST_REVERSED = 336;

/* A blocked wheel's wanted position runs ahead no further than full voltage can follow. */
static const int32_t MAX_POSITION_ERROR_Q8 = INT32_C(728) * 256;

static int32_t position_error_q8[BODY_WHEELS]; /* counts times 2^8 until where the wheel shall be */
static int32_t counts_now[BODY_WHEELS];
static int32_t moved[BODY_WHEELS]; /* counts in the last period */
static struct brake brake;
static bool is_braked;
static bool is_reversed[BODY_WHEELS];
static uint8_t checked_wheel; /* the wheel whose brake was updated last */

bool drive_begin(void)
{
    pwm_bus_begin();
    memset(position_error_q8, 0, sizeof position_error_q8);
    memset(counts_now, 0, sizeof counts_now);
    memset(moved, 0, sizeof moved);
    is_braked = true;
    return true;
}

bool drive_read_counts(int32_t counts[BODY_WHEELS])
{
    pwm_bus_counts(counts);
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        moved[wheel] = counts[wheel] - counts_now[wheel];
        counts_now[wheel] = counts[wheel];
    }
    return true;
}

static int32_t clamped(int32_t value, int32_t limit)
{
    if (value > limit) {
        return limit;
    }
    return value < -limit ? -limit : value;
}

bool drive_turn(const struct wheel_rates *rates)
{
    is_braked = false;
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        int32_t to_move_q8 = rates->q8[wheel] * DRIVE_PERIOD_MS / 1000;
        int32_t forward = ((rates->q8[wheel] >> 8) * FORWARD_Q16) >> 16;
        int32_t more;

        position_error_q8[wheel] =
            clamped(position_error_q8[wheel] + to_move_q8 - moved[wheel] * 256,
                    MAX_POSITION_ERROR_Q8);
        more = (position_error_q8[wheel] * GAIN_Q8) >> 16;
        pwm_bus_drive(wheel, (int16_t)clamped(forward + more, PWM_FULL));
    }
    return true;
}

/* The voltage, as a rate, that is to brake a wheel: twice what keeps it turning, or all there is. */
static int32_t braking_voltage(int32_t rate)
{
    bool is_slow = rate < SLOWEST_REVERSED && rate > -SLOWEST_REVERSED;

    return is_slow ? 0 : clamped(-2 * rate, FULL_RATE);
}

static void reverse_wheel(uint8_t wheel, int32_t voltage)
{
    int16_t duty = (int16_t)clamped((voltage * FORWARD_Q16) >> 16, PWM_FULL);

    position_error_q8[wheel] = 0;
    is_reversed[wheel] = voltage != 0;
    if (voltage != 0) {
        pwm_bus_drive_until(wheel, duty, BRAKE_MAX_MS_Q4);
    } else {
        pwm_bus_drive(wheel, 0);
    }
}

/* All motors at once; what takes longer comes after. */
static void begin_to_brake(void)
{
    int32_t counts[BODY_WHEELS];
    int32_t rates[BODY_WHEELS];
    int32_t voltages[BODY_WHEELS];

    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        rates[wheel] = pwm_bus_moved(wheel) * (1000 / PWM_BUS_MOVED_MS);
        voltages[wheel] = braking_voltage(rates[wheel]);
    }
    is_braked = true;
    pwm_bus_begin_time();
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        reverse_wheel(wheel, voltages[wheel]);
    }
    pwm_bus_counts(counts);
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        if (voltages[wheel] != 0) {
            brake_begin_reversing(&brake, wheel, counts[wheel], rates[wheel], voltages[wheel]);
        }
    }
}

/* The end of it comes by interrupt: the main loop may be late by some milliseconds. */
static void update_brake_end(uint8_t wheel)
{
    int32_t counts[BODY_WHEELS];
    uint16_t now_ms_q4;
    uint16_t end_ms_q4;

    now_ms_q4 = pwm_bus_ms_q4();
    pwm_bus_counts(counts);
    end_ms_q4 = brake_end_ms_q4(&brake, wheel, counts[wheel], now_ms_q4);
    pwm_bus_end_at(wheel, end_ms_q4);
    is_reversed[wheel] = end_ms_q4 > now_ms_q4;
}

bool drive_stop(void)
{
    if (!is_braked) {
        begin_to_brake();
        return true;
    }
    /* one is enough at a time */
    checked_wheel = (uint8_t)(checked_wheel + 1U == BODY_WHEELS ? 0 : checked_wheel + 1U);
    if (is_reversed[checked_wheel]) {
        update_brake_end(checked_wheel);
    }
    return true;
}

/* The motors are left short-circuited. */
bool drive_rest(void)
{
    return true;
}
