#include "clock.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "drive_bus.h"
#include "spi_slave.h"

enum { PRESCALER = 64, TOP = F_CPU / PRESCALER / 1000 - 1 };

_Static_assert(F_CPU % (PRESCALER * 1000UL) == 0 && TOP <= 255, "timer 0 cannot count this clock");

/* Written by the interrupt, read by the main loop. */
static volatile uint8_t ticks;

void clock_begin(void)
{
    OCR0 = TOP;
    TCCR0 = _BV(WGM01) | _BV(CS02); /* back to 0 at OCR0; clock/64 */
    TIMSK |= _BV(OCIE0);
}

uint8_t clock_ticks(void)
{
    return ticks;
}

/*
 * Counts the millisecond, lets the SPI notice a pause and the drive end what it has timed. Refuses
 * everything else, and is interrupted by all others, so that it does not count where the SPI waits;
 * docs/firmware.md states what was measured.
 */
ISR(TIMER0_COMP_vect, ISR_NOBLOCK)
{
    ticks++;
    spi_slave_on_millisecond();
    drive_bus_on_millisecond();
}
