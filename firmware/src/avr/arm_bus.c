#include "arm_bus.h"

#include <avr/io.h>

#include "board.h"
#include "sensors.h"

enum {
    PRESCALER = 8,
    COUNTS_A_MS = F_CPU / PRESCALER / 1000,
    PULSES_A_COUNT = 2000 / COUNTS_A_MS, /* units of arm_pulse: 0.5 us */
    PERIOD_MS = 5,
    LATEST_TO_ASK = 2 * COUNTS_A_MS,
    PULSE_IS_OVER = COUNTS_A_MS / 10U * 26U, /* 2.6 ms, the longest */
    PULSE_IS_NEAR = COUNTS_A_MS / 10U * 46U, /* 4.6 ms */
};

_Static_assert(PULSES_A_COUNT * COUNTS_A_MS == 2000, "timer 3 cannot count this clock");

static enum arm_channel channel;

/* Of this period: the sensor is to be asked for, was asked for, was measured. */
static enum { TO_ASK, ASKED, MEASURED } sampling;

void arm_bus_begin(void)
{
    ARM_SELECT_DDR |= ARM_SELECT;
    ARM_PULSE_DDR |= ARM_PULSE;
    ICR3 = PERIOD_MS * COUNTS_A_MS - 1;
    TCCR3A = _BV(WGM31); /* fast PWM up to ICR3; the pulse comes when there is one */
    TCCR3B = _BV(WGM33) | _BV(WGM32) | _BV(CS31);
}

/* The next pulse is as long as that; OCR3A takes effect with it. */
static void set_pulse(uint16_t pulse)
{
    if (pulse == 0) {
        TCCR3A = _BV(WGM31);
        return;
    }
    OCR3A = pulse / PULSES_A_COUNT - 1;
    TCCR3A = _BV(COM3A1) | _BV(WGM31);
}

static void choose(enum arm_channel next)
{
    unsigned others = ARM_SELECT_PORT & ~(unsigned)ARM_SELECT;

    ARM_SELECT_PORT = (uint8_t)(others | (unsigned)next << ARM_SELECT_0);
    channel = next;
}

void arm_bus_step(struct arm *arm)
{
    uint16_t mv;
    uint16_t now;

    if (!arm_is_fitted(arm)) {
        set_pulse(0);
        return;
    }
    now = TCNT3;
    if (sampling == TO_ASK && now < LATEST_TO_ASK) {
        sensors_ask_arm();
        sampling = ASKED;
    } else if (sampling == ASKED && sensors_take_arm(&mv)) {
        arm_measure(arm, channel, mv);
        sampling = MEASURED;
    }
    if (sampling == MEASURED && now >= PULSE_IS_OVER && now <= PULSE_IS_NEAR) {
        choose((enum arm_channel)((channel + 1U) % ARM_CHANNELS));
        set_pulse(arm_pulse(arm, channel));
        sampling = TO_ASK;
    }
}
