/*
 * The drive of the ED-7275: three LM629 motion controllers in velocity mode, whose velocity is
 * changed in motion. Each keeps its trajectory and its PID by itself; here it is only commanded. All
 * get the same command before any gets the next: so they are busy at the same time, and not one
 * after the other. A function that commands axes returns those of them that accepted it.
 */
#include <string.h>

#include "brake.h"
#include "drive.h"
#include "lm629_bus.h"
#include "lm629_codes.h"

#define CLOCK_HZ 6000000

enum {
    CLOCKS_A_SAMPLE = 2048,

    /* A command takes the LM629 100 us at most; a read of its status takes 2 us or more. */
    MAX_STATUS_READS = 200,

    PROPORTIONAL = 400,
    DERIVATIVE = 4400,
    REVERSING_PROPORTIONAL = 4000, /* full voltage from 8 counts on */

    CHECK_PERIOD_MS = 2, /* at braked wheels: it takes half a millisecond */

    /* Counts a second, 0.27 m/s at the rim: what is slower, the filter brakes as soon. */
    SLOWEST_REVERSED = 3000,
    DERIVATIVE_INTERVAL = 9, /* samples, less 1 */
    MAX_POSITION_ERROR = 2808, /* counts: a turn; then the LM629 stops by itself */

    ALL_AXES = (1 << BODY_WHEELS) - 1, /* bit 0 to 2 */
};

/* Counts a sample times 2^16, for a rate of 1 (counts a second times 2^8); times 2^24. */
static const int64_t VELOCITY_Q24 =
    (INT64_C(1) << (24 + 16 - 8)) * CLOCKS_A_SAMPLE / CLOCK_HZ;

/* 33 m/s2 at the rim: more than what is commanded, which is slewed already. */
#define ACCELERATION_COUNTS_S2 366600

/* Counts a sample squared, times 2^16. */
static const int32_t ACCELERATION =
    (int32_t)(INT64_C(65536) * ACCELERATION_COUNTS_S2 * CLOCKS_A_SAMPLE / CLOCK_HZ *
              CLOCKS_A_SAMPLE / CLOCK_HZ);

static enum motion { TURNING, BRAKED, OFF } motion;
static int32_t counts_now[BODY_WHEELS];
static int32_t moved[BODY_WHEELS];        /* counts in the last period */
static int32_t moved_before[BODY_WHEELS]; /* and in the one before */
static struct brake brake;
static uint8_t reversed; /* axes that are still to be */
static uint8_t braked_ms;

static bool is_in(uint8_t axes, uint8_t axis)
{
    return ((unsigned)axes >> axis & 1U) != 0;
}

static bool is_ready(uint8_t axis)
{
    for (uint8_t read = 0; read < MAX_STATUS_READS; read++) {
        if ((lm629_bus_status(axis) & LM629_BUSY) == 0) {
            return true;
        }
    }
    return false;
}

static uint8_t wait_until_ready(uint8_t axes)
{
    uint8_t found = 0;

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(axes, axis) && is_ready(axis)) {
            found = (uint8_t)(found | 1U << axis);
        }
    }
    return found;
}

static uint8_t command(uint8_t axes, enum lm629_command code)
{
    uint8_t accepted = wait_until_ready(axes);

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(accepted, axis)) {
            lm629_bus_command(axis, (uint8_t)code);
        }
    }
    return accepted;
}

static uint8_t write_words(uint8_t axes, const uint16_t words[BODY_WHEELS])
{
    uint8_t accepted = wait_until_ready(axes);

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(accepted, axis)) {
            lm629_bus_write(axis, (uint8_t)(words[axis] >> 8));
            lm629_bus_write(axis, (uint8_t)(words[axis] & 0xFFU));
        }
    }
    return accepted;
}

static uint8_t write_word(uint8_t axes, uint16_t word)
{
    const uint16_t words[BODY_WHEELS] = {word, word, word};

    return write_words(axes, words);
}

static uint8_t write_longs(uint8_t axes, const uint32_t values[BODY_WHEELS])
{
    uint16_t high[BODY_WHEELS];
    uint16_t low[BODY_WHEELS];

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        high[axis] = (uint16_t)(values[axis] >> 16);
        low[axis] = (uint16_t)(values[axis] & 0xFFFFU);
    }
    return write_words(write_words(axes, high), low);
}

static uint8_t write_long(uint8_t axes, uint32_t value)
{
    const uint32_t values[BODY_WHEELS] = {value, value, value};

    return write_longs(axes, values);
}

static uint8_t read_words(uint8_t axes, uint16_t words[BODY_WHEELS])
{
    uint8_t accepted = wait_until_ready(axes);

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(accepted, axis)) {
            uint8_t high = lm629_bus_read(axis);

            words[axis] = (uint16_t)((uint16_t)((uint16_t)high << 8) | lm629_bus_read(axis));
        }
    }
    return accepted;
}

/* Takes effect by LM629_UPDATE_FILTER. */
static uint8_t load_filter(uint8_t axes, uint16_t proportional, uint16_t derivative)
{
    axes = write_word(command(axes, LM629_LOAD_FILTER),
                      (DERIVATIVE_INTERVAL << 8) | LM629_HAS_PROPORTIONAL | LM629_HAS_DERIVATIVE);
    return write_word(write_word(axes, proportional), derivative);
}

static uint8_t set_filter(uint8_t axes, uint16_t proportional, uint16_t derivative)
{
    return command(load_filter(axes, proportional, derivative), LM629_UPDATE_FILTER);
}

static uint8_t load_limits(uint8_t axes)
{
    axes = write_word(command(axes, LM629_LIMIT_AND_STOP), MAX_POSITION_ERROR);
    axes = write_word(command(axes, LM629_LOAD_TRAJECTORY),
                      LM629_VELOCITY_MODE | LM629_HAS_ACCELERATION | LM629_HAS_VELOCITY);
    return write_long(write_long(axes, (uint32_t)ACCELERATION), 0);
}

static bool has_error(uint8_t axes, uint8_t errors)
{
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(axes, axis) && (lm629_bus_status(axis) & errors) != 0) {
            return true;
        }
    }
    return false;
}

static uint8_t read_positions(uint8_t axes, int32_t counts[BODY_WHEELS])
{
    uint16_t high[BODY_WHEELS];
    uint16_t low[BODY_WHEELS];

    axes = read_words(read_words(command(axes, LM629_READ_POSITION), high), low);
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(axes, axis)) {
            counts[axis] = (int32_t)(((uint32_t)high[axis] << 16) | low[axis]);
        }
    }
    return axes;
}

bool drive_read_counts(int32_t counts[BODY_WHEELS])
{
    if (read_positions(ALL_AXES, counts) != ALL_AXES) {
        return false;
    }
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        moved_before[axis] = moved[axis];
        moved[axis] = counts[axis] - counts_now[axis];
        counts_now[axis] = counts[axis];
    }
    return true;
}

/*
 * False after a command error, or an error of position after which the LM629 has stopped its motor.
 * The LM629 reports it once, and can be used again.
 */
static bool clear_errors(uint8_t axes)
{
    bool is_ready = wait_until_ready(axes) == axes;

    if (has_error(axes, LM629_COMMAND_ERROR | LM629_POSITION_ERROR)) {
        (void)write_word(command(axes, LM629_RESET_INTERRUPTS), 0);
        return false;
    }
    return is_ready;
}

/* Starts what was loaded into all of the axes that accepted it. */
static bool start(uint8_t axes, uint8_t loaded)
{
    return command(loaded, LM629_START) == axes && clear_errors(axes);
}

static bool stop(uint8_t axes, uint16_t manner)
{
    return start(axes, write_word(command(axes, LM629_LOAD_TRAJECTORY),
                                  LM629_VELOCITY_MODE | manner));
}

bool drive_begin(void)
{
    uint8_t axes;

    lm629_bus_reset();
    memset(counts_now, 0, sizeof counts_now);
    memset(moved, 0, sizeof moved);
    memset(moved_before, 0, sizeof moved_before);
    axes = load_limits(write_word(command(ALL_AXES, LM629_RESET_INTERRUPTS), 0));
    motion = OFF;
    return axes == ALL_AXES && clear_errors(axes);
}

bool drive_turn(const struct wheel_rates *rates)
{
    uint16_t words[BODY_WHEELS];
    uint32_t velocities[BODY_WHEELS];
    uint8_t axes = ALL_AXES;

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        int32_t rate_q8 = rates->q8[axis];
        uint16_t direction = rate_q8 < 0 ? 0 : LM629_FORWARD;
        int64_t speed_q8 = rate_q8 < 0 ? -(int64_t)rate_q8 : rate_q8;

        words[axis] = (uint16_t)(LM629_VELOCITY_MODE | LM629_HAS_VELOCITY | direction);
        velocities[axis] = (uint32_t)((speed_q8 * VELOCITY_Q24 + (INT64_C(1) << 23)) >> 24);
    }
    if (motion != TURNING) {
        motion = TURNING;
        axes = set_filter(axes, PROPORTIONAL, DERIVATIVE);
    }
    axes = write_words(command(axes, LM629_LOAD_TRAJECTORY), words);
    return start(ALL_AXES, write_longs(axes, velocities));
}

/*
 * A trajectory that slows down would end where the wheel should have stopped, and first catch up what
 * it was behind. So fast wheels are reversed: driven back with full voltage to where they are
 * now, until they are stopped. Slow ones, and stopped ones, are only damped.
 */
static bool begin_to_brake(uint8_t axes)
{
    int32_t counts[BODY_WHEELS];
    uint8_t slow;

    motion = BRAKED;
    (void)stop(axes, LM629_STOP_ABRUPTLY);
    axes = read_positions(axes, counts);
    reversed = 0;
    braked_ms = 0;
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        int32_t rate = (moved[axis] + moved_before[axis]) * (500 / DRIVE_PERIOD_MS);

        if (is_in(axes, axis) && (rate >= SLOWEST_REVERSED || rate <= -SLOWEST_REVERSED)) {
            brake_begin_reversing(&brake, axis, counts[axis], rate, WHEEL_RATED_Q8 / 256);
            reversed = (uint8_t)(reversed | 1U << axis);
        }
    }
    slow = (uint8_t)(axes & ~(unsigned)reversed);
    (void)load_filter(set_filter(reversed, REVERSING_PROPORTIONAL, 0), 0, DERIVATIVE);
    (void)set_filter(slow, 0, DERIVATIVE);
    return clear_errors(axes);
}

/* Returns the axes that are stopped now and need not be reversed any more. */
static uint8_t standing_axes(uint8_t axes)
{
    int32_t counts[BODY_WHEELS];
    uint8_t found = 0;

    axes = read_positions(axes, counts);
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (is_in(axes, axis) &&
            brake_has_stopped(&brake, axis, counts[axis], (uint16_t)(braked_ms * 16U + 8U))) {
            found = (uint8_t)(found | 1U << axis);
        }
    }
    return found;
}

static bool continue_braking(uint8_t axes)
{
    if (reversed == 0) {
        return clear_errors(axes);
    }
    braked_ms++;
    if (braked_ms % CHECK_PERIOD_MS != 0) {
        return true;
    }
    reversed &= (uint8_t)~command(standing_axes(reversed & axes), LM629_UPDATE_FILTER);
    return true;
}

/* A controller that does not answer does not keep the others from braking. */
bool drive_stop(void)
{
    uint8_t axes = wait_until_ready(ALL_AXES);
    bool is_good;

    switch (motion) {
    case TURNING:
        is_good = begin_to_brake(axes);
        break;
    case BRAKED:
        is_good = continue_braking(axes);
        break;
    default:
        is_good = clear_errors(axes);
    }
    return is_good && axes == ALL_AXES;
}

bool drive_rest(void)
{
    uint8_t axes = wait_until_ready(ALL_AXES);

    if (motion != OFF) {
        motion = OFF;
        (void)stop(axes, LM629_TURN_MOTOR_OFF);
    }
    return clear_errors(axes) && axes == ALL_AXES;
}
