#include "clock.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/atomic.h>

#include "spi_slave.h"

enum { PRESCALER = 64, TOP = F_CPU / PRESCALER / 1000 - 1 };

_Static_assert(F_CPU % (PRESCALER * 1000UL) == 0 && TOP <= 255, "timer 0 cannot count this clock");

/* Written by the interrupt, read by the main loop. */
static volatile uint32_t now_ms;

void clock_begin(void)
{
    OCR0 = TOP;
    TCCR0 = _BV(WGM01) | _BV(CS02); /* back to 0 at OCR0; clock/64 */
    TIMSK |= _BV(OCIE0);
}

uint32_t clock_ms(void)
{
    uint32_t ms;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        ms = now_ms;
    }
    return ms;
}

/*
 * Counts the millisecond and lets the SPI notice a pause. Refuses everything else.
 * Budget 128 cycles, so that with the SPI's own routine a byte every 256 cycles is never lost;
 * docs/firmware.md states what was measured.
 */
ISR(TIMER0_COMP_vect)
{
    now_ms++;
    spi_slave_millisecond();
}
