#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdbool.h>
#include <util/atomic.h>

#include "board.h"
#include "pwm_bus.h"

/* Written by the encoders' interrupts, read by the main loop. */
static volatile int32_t encoder[BODY_WHEELS];

void pwm_bus_begin(void)
{
    /* phase-correct, 8 bits, not inverted; clock/1: 31 kHz */
    TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(COM1C1) | _BV(WGM10);
    TCCR1B = _BV(CS10);
    PWM_DDR |= PWM_PINS;
    DIRECTION_DDR |= DIRECTION(0) | DIRECTION(1) | DIRECTION(2);
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        pwm_bus_drive(wheel, 0);
        ENCODER_A_PORT = (uint8_t)(ENCODER_A_PORT | ENCODER_A(wheel)); /* pull-ups */
        ENCODER_B_PORT = (uint8_t)(ENCODER_B_PORT | ENCODER_B(wheel));
    }
    EICRB |= _BV(ISC40) | _BV(ISC50) | _BV(ISC60); /* every edge */
    EIMSK |= _BV(INT4) | _BV(INT5) | _BV(INT6);
}

void pwm_bus_drive(uint8_t wheel, int16_t duty)
{
    uint16_t magnitude = (uint16_t)(duty < 0 ? -duty : duty);

    if (duty < 0) {
        DIRECTION_PORT = (uint8_t)(DIRECTION_PORT | DIRECTION(wheel));
    } else {
        DIRECTION_PORT = (uint8_t)(DIRECTION_PORT & ~DIRECTION(wheel));
    }
    switch (wheel) {
    case 0:
        OCR1A = magnitude;
        break;
    case 1:
        OCR1B = magnitude;
        break;
    default:
        OCR1C = magnitude;
        break;
    }
}

void pwm_bus_counts(int32_t counts[BODY_WHEELS])
{
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
            counts[wheel] = encoder[wheel];
        }
    }
}

/* An edge of A: two counts of the quadrature, forward where A and B differ. */
static inline void count(uint8_t wheel)
{
    bool a = (ENCODER_A_PIN & ENCODER_A(wheel)) != 0;
    bool b = (ENCODER_B_PIN & ENCODER_B(wheel)) != 0;

    encoder[wheel] += a != b ? 2 : -2;
}

/*
 * Each counts one edge and refuses everything else. At the rated speed there are 5,150 edges a
 * second of each. Budget 128 cycles; docs/firmware.md states what was measured.
 */
ISR(INT4_vect)
{
    count(0);
}

ISR(INT5_vect)
{
    count(1);
}

ISR(INT6_vect)
{
    count(2);
}
