#include <avr/interrupt.h>
#include <avr/io.h>

#include "board.h"
#include "drive_bus.h"
#include "pwm_bus.h"

/* Edges forward, less those backward, modulo 256: written by the interrupts, read by the main loop. */
static volatile uint8_t edges[BODY_WHEELS] __attribute__((used));

/* Milliseconds: written by the clock's interrupt, begun by the main loop. */
static volatile uint8_t passed_ms = UINT8_MAX;
static uint8_t begun_ms_q4; /* in the clock's millisecond; main loop only */

/* When a wheel's duty becomes 0: written by the main loop, and NEVER by the interrupt that did it. */
enum { NEVER = 0 };
static volatile uint8_t end_ms[BODY_WHEELS];

/* The counts of the last milliseconds modulo 256: written by the clock's interrupt. */
enum { TRAIL = 32, HALF_MS = PWM_BUS_MOVED_MS / 2 }; /* a power of two */
static volatile uint8_t trail[TRAIL][BODY_WHEELS];
static volatile uint8_t newest;

static uint8_t edges_before[BODY_WHEELS];
static int32_t edge_counts[BODY_WHEELS];

/*
 * An edge of A is two counts of the quadrature, and the pins show which of them it is: while A and
 * B differ, the wheel is a count before where the last edge forward puts it.
 */
struct encoder_position {
    uint8_t edges;
    uint8_t counts_before;
};

static inline struct encoder_position encoder_position_of(uint8_t wheel)
{
    struct encoder_position encoder_position;
    uint8_t differing;

    do {
        encoder_position.edges = edges[wheel];
        differing = (uint8_t)((ENCODER_A_PIN ^ ENCODER_B_PIN) & ENCODER_A(wheel));
    } while (encoder_position.edges != edges[wheel]);
    encoder_position.counts_before = differing != 0;
    return encoder_position;
}

void pwm_bus_begin(void)
{
    /* phase-correct, 8 bits, not inverted; clock/510: 31 kHz at 16 MHz, 16 kHz at 8 MHz */
    TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(COM1C1) | _BV(WGM10);
    TCCR1B = _BV(CS10);
    PWM_DDR |= PWM_PINS;
    DIRECTION_DDR |= DIRECTION(0) | DIRECTION(1) | DIRECTION(2);
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        pwm_bus_drive(wheel, 0);
        ENCODER_A_PORT = (uint8_t)(ENCODER_A_PORT | ENCODER_A(wheel)); /* pull-ups */
        ENCODER_B_PORT = (uint8_t)(ENCODER_B_PORT | ENCODER_B(wheel));
        edges_before[wheel] = edges[wheel];
        edge_counts[wheel] = encoder_position_of(wheel).counts_before;
    }
    EICRB |= _BV(ISC40) | _BV(ISC50) | _BV(ISC60); /* every edge */
    EIFR = _BV(INTF4) | _BV(INTF5) | _BV(INTF6); /* forgets edges that setting it up made */
    EIMSK |= _BV(INT4) | _BV(INT5) | _BV(INT6);
}

static void set_width(uint8_t wheel, uint8_t width)
{
    switch (wheel) {
    case 0:
        OCR1A = width;
        break;
    case 1:
        OCR1B = width;
        break;
    default:
        OCR1C = width;
        break;
    }
}

void pwm_bus_drive(uint8_t wheel, int16_t duty)
{
    end_ms[wheel] = NEVER;
    if (duty < 0) {
        DIRECTION_PORT = (uint8_t)(DIRECTION_PORT | DIRECTION(wheel));
    } else {
        DIRECTION_PORT = (uint8_t)(DIRECTION_PORT & ~DIRECTION(wheel));
    }
    set_width(wheel, (uint8_t)(duty < 0 ? -duty : duty));
}

/* Times 2^4: what has passed of the clock's millisecond. */
static uint8_t fraction_ms_q4(void)
{
    return (uint8_t)(TCNT0 * 16U / (OCR0 + 1U));
}

void pwm_bus_begin_time(void)
{
    passed_ms = 0;
    begun_ms_q4 = fraction_ms_q4();
}

uint16_t pwm_bus_ms_q4(void)
{
    uint8_t ms;
    uint8_t fraction_q4;

    do {
        ms = passed_ms;
        fraction_q4 = fraction_ms_q4();
    } while (ms != passed_ms);
    return (uint16_t)(ms * 16U + fraction_q4 - begun_ms_q4);
}

/* The next whole millisecond of the clock. */
static uint8_t clock_ms_of(uint16_t ms_q4)
{
    return (uint8_t)((ms_q4 + begun_ms_q4 + 15U) / 16U);
}

void pwm_bus_drive_until(uint8_t wheel, int16_t duty, uint16_t ms_q4)
{
    pwm_bus_drive(wheel, duty);
    end_ms[wheel] = clock_ms_of(ms_q4);
}

void pwm_bus_end_at(uint8_t wheel, uint16_t ms_q4)
{
    if (end_ms[wheel] != NEVER) {
        end_ms[wheel] = clock_ms_of(ms_q4);
    }
}

/* The high bytes of the timer's registers are 0 here and there: neither disturbs the other. */
static inline void end_timed_duties(void)
{
    if (passed_ms == UINT8_MAX) {
        return;
    }
    passed_ms++;
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        if (end_ms[wheel] != NEVER && passed_ms >= end_ms[wheel]) {
            end_ms[wheel] = NEVER;
            set_width(wheel, 0);
        }
    }
}

void drive_bus_on_millisecond(void)
{
    uint8_t at = (uint8_t)((newest + 1U) % TRAIL);

    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        struct encoder_position encoder_position = encoder_position_of(wheel);

        trail[at][wheel] = (uint8_t)(2U * encoder_position.edges - encoder_position.counts_before);
    }
    newest = at;
    end_timed_duties();
}

/* Half of it is less than 128 counts. */
int32_t pwm_bus_moved(uint8_t wheel)
{
    uint8_t last = newest;
    uint8_t now = trail[last][wheel];
    uint8_t middle = trail[(uint8_t)(last - HALF_MS) % TRAIL][wheel];
    uint8_t before = trail[(uint8_t)(last - 2 * HALF_MS) % TRAIL][wheel];

    return (int8_t)(uint8_t)(now - middle) + (int8_t)(uint8_t)(middle - before);
}

void pwm_bus_counts(int32_t counts[BODY_WHEELS])
{
    for (uint8_t wheel = 0; wheel < BODY_WHEELS; wheel++) {
        struct encoder_position encoder_position = encoder_position_of(wheel);

        edge_counts[wheel] += 2 * (int8_t)(uint8_t)(encoder_position.edges - edges_before[wheel]);
        edges_before[wheel] = encoder_position.edges;
        counts[wheel] = edge_counts[wheel] - encoder_position.counts_before;
    }
}

/*
 * Each counts one edge, forward where A and B differ, and refuses everything else. At the rated
 * speed there are 5,150 edges a second of each, and up to three at once while a byte waits: so they
 * are written in assembler, where the compiler would save twice as many registers as they need.
 * Budget 40 cycles; docs/firmware.md states what was measured.
 */
#define COUNT_EDGES(interrupt, wheel)                                                      \
    ISR(interrupt, ISR_NAKED)                                                              \
    {                                                                                      \
        __asm__ volatile("push r24\n\t"                                                    \
                         "in   r24, __SREG__\n\t"                                          \
                         "push r24\n\t"                                                    \
                         "push r25\n\t"                                                    \
                         "in   r24, %[a]\n\t"                                              \
                         "in   r25, %[b]\n\t"                                              \
                         "eor  r24, r25\n\t"                                               \
                         "lds  r25, edges+" #wheel "\n\t"                                  \
                         "dec  r25\n\t"                                                    \
                         "sbrc r24, 4+" #wheel "\n\t"                                      \
                         "subi r25, -2\n\t"                                                \
                         "sts  edges+" #wheel ", r25\n\t"                                  \
                         "pop  r25\n\t"                                                    \
                         "pop  r24\n\t"                                                    \
                         "out  __SREG__, r24\n\t"                                          \
                         "pop  r24\n\t"                                                    \
                         "reti"                                                            \
                         :                                                                 \
                         : [a] "I"(_SFR_IO_ADDR(ENCODER_A_PIN)),                           \
                           [b] "I"(_SFR_IO_ADDR(ENCODER_B_PIN)));                          \
    }

_Static_assert(ENCODER_A(0) == _BV(4) && ENCODER_B(0) == _BV(4), "A and B are the same bits");

COUNT_EDGES(INT4_vect, 0)
COUNT_EDGES(INT5_vect, 1)
COUNT_EDGES(INT6_vect, 2)
