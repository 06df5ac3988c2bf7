/*
 * The drive of the ED-7275: three LM629 motion controllers in velocity mode, whose velocity is
 * changed in motion. Each keeps its trajectory and its PID by itself; here it is only told.
 */
#include "drive.h"
#include "lm629_bus.h"
#include "lm629_codes.h"

#define CLOCK_HZ 6000000

enum {
    CLOCKS_A_SAMPLE = 2048,

    /* A command takes the LM629 100 us at most; a look at its status takes 2 us or more. */
    MOST_LOOKS = 200,

    PROPORTIONAL = 400,
    DERIVATIVE = 4400,
    DERIVATIVE_INTERVAL = 9, /* samples, less 1 */
    MOST_POSITION_ERROR = 2808, /* counts: a turn; then the LM629 stops by itself */
    
};

/* Counts a sample times 2^16, for a rate of 1 (counts a second times 2^8); times 2^24. */
static const int64_t VELOCITY_Q24 =
    (INT64_C(1) << (24 + 16 - 8)) * CLOCKS_A_SAMPLE / CLOCK_HZ;

/* 33 m/s2 at the rim, to brake with; what else is told is slewed already. */
#define ACCELERATION_COUNTS_S2 366600

/* Counts a sample squared, times 2^16. */
static const int32_t ACCELERATION =
    (int32_t)(INT64_C(65536) * ACCELERATION_COUNTS_S2 * CLOCKS_A_SAMPLE / CLOCK_HZ *
              CLOCKS_A_SAMPLE / CLOCK_HZ);

static bool is_ready(uint8_t axis)
{
    for (uint8_t look = 0; look < MOST_LOOKS; look++) {
        if ((lm629_bus_status(axis) & LM629_BUSY) == 0) {
            return true;
        }
    }
    return false;
}

static bool command(uint8_t axis, enum lm629_command code)
{
    if (!is_ready(axis)) {
        return false;
    }
    lm629_bus_command(axis, (uint8_t)code);
    return true;
}

static bool write_word(uint8_t axis, uint16_t word)
{
    if (!is_ready(axis)) {
        return false;
    }
    lm629_bus_write(axis, (uint8_t)(word >> 8));
    lm629_bus_write(axis, (uint8_t)(word & 0xFFU));
    return true;
}

static bool write_long(uint8_t axis, uint32_t value)
{
    return write_word(axis, (uint16_t)(value >> 16)) &&
           write_word(axis, (uint16_t)(value & 0xFFFFU));
}

static bool read_word(uint8_t axis, uint16_t *word)
{
    uint8_t high;

    if (!is_ready(axis)) {
        return false;
    }
    high = lm629_bus_read(axis);
    *word = (uint16_t)((uint16_t)((uint16_t)high << 8) | lm629_bus_read(axis));
    return true;
}

static bool load_filter(uint8_t axis)
{
    return command(axis, LM629_LOAD_FILTER) &&
           write_word(axis, (DERIVATIVE_INTERVAL << 8) | LM629_HAS_PROPORTIONAL |
                                LM629_HAS_DERIVATIVE) &&
           write_word(axis, PROPORTIONAL) && write_word(axis, DERIVATIVE) &&
           command(axis, LM629_UPDATE_FILTER);
}

static bool load_limits(uint8_t axis)
{
    return command(axis, LM629_LIMIT_AND_STOP) && write_word(axis, MOST_POSITION_ERROR) &&
           command(axis, LM629_LOAD_TRAJECTORY) &&
           write_word(axis, LM629_VELOCITY_MODE | LM629_HAS_ACCELERATION | LM629_HAS_VELOCITY) &&
           write_long(axis, (uint32_t)ACCELERATION) && write_long(axis, 0);
}

static bool begin(uint8_t axis)
{
    return command(axis, LM629_RESET_INTERRUPTS) && write_word(axis, 0) && load_filter(axis) &&
           load_limits(axis) && is_ready(axis) &&
           (lm629_bus_status(axis) & LM629_COMMAND_ERROR) == 0;
}

bool drive_begin(void)
{
    bool is_good = true;

    lm629_bus_reset();
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        is_good = begin(axis) && is_good;
    }
    return is_good;
}

static bool read_position(uint8_t axis, int32_t *counts)
{
    uint16_t high;
    uint16_t low;

    if (!command(axis, LM629_READ_POSITION) || !read_word(axis, &high) || !read_word(axis, &low)) {
        return false;
    }
    *counts = (int32_t)(((uint32_t)high << 16) | low);
    return true;
}

bool drive_read_counts(int32_t counts[BODY_WHEELS])
{
    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        if (!read_position(axis, &counts[axis])) {
            return false;
        }
    }
    return true;
}

/*
 * False after a command error, or an error of position after which the LM629 has stopped its motor.
 * The LM629 tells it once, and can be used again.
 */
static bool is_faultless(uint8_t axis)
{
    if ((lm629_bus_status(axis) & (LM629_COMMAND_ERROR | LM629_POSITION_ERROR)) == 0) {
        return true;
    }
    if (command(axis, LM629_RESET_INTERRUPTS)) {
        (void)write_word(axis, 0);
    }
    return false;
}

static bool turn(uint8_t axis, int32_t rate_q8)
{
    uint16_t direction = rate_q8 < 0 ? 0 : LM629_FORWARD;
    int64_t speed_q8 = rate_q8 < 0 ? -(int64_t)rate_q8 : rate_q8;
    uint32_t velocity = (uint32_t)((speed_q8 * VELOCITY_Q24 + (INT64_C(1) << 23)) >> 24);

    return command(axis, LM629_LOAD_TRAJECTORY) &&
           write_word(axis,
                      (uint16_t)(LM629_VELOCITY_MODE | LM629_HAS_VELOCITY | direction)) &&
           write_long(axis, velocity) && command(axis, LM629_START) && is_ready(axis) &&
           is_faultless(axis);
}

bool drive_turn(const struct wheel_rates *rates)
{
    bool is_good = true;

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        is_good = turn(axis, rates->q8[axis]) && is_good;
    }
    return is_good;
}

bool drive_stop(void)
{
    static const struct wheel_rates still = {{0, 0, 0}};

    return drive_turn(&still);
}

static bool hold(uint8_t axis)
{
    return command(axis, LM629_LOAD_TRAJECTORY) &&
           write_word(axis, LM629_VELOCITY_MODE | LM629_STOP_ABRUPTLY) &&
           command(axis, LM629_START) && is_ready(axis) && is_faultless(axis);
}

bool drive_hold(void)
{
    bool is_good = true;

    for (uint8_t axis = 0; axis < BODY_WHEELS; axis++) {
        is_good = hold(axis) && is_good;
    }
    return is_good;
}
