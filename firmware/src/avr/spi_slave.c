#include "spi_slave.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <string.h>
#include <util/atomic.h>

#include "board.h"

enum {
    RING = 256, /* four frames; indices wrap around by themselves */
    PAUSE_MS = 2,
};

/* Ring: head written by the interrupt, tail by the main loop. */
static volatile uint8_t ring[RING];
static volatile uint8_t head;
static volatile uint8_t tail;
static volatile uint16_t lost; /* written by the interrupt */

/* Silence: set to 0 by the SPI interrupt, counted and its end told by the clock's. */
static volatile uint8_t silent_ms;
static volatile bool is_paused; /* set by the clock's interrupt, reset by the main loop */

/*
 * Three statuses: the interrupt sends one, one is offered for the next exchange, the main loop
 * writes another. So there is always a whole one to send, also for a master whose exchanges fall
 * into the writing every time.
 */
static uint8_t statuses[3][FRAME_LENGTH];
static volatile uint8_t sent;    /* written by the interrupt, between exchanges only */
static volatile uint8_t offered; /* written by the main loop */
static uint8_t draft;            /* main loop only */
static volatile uint8_t position; /* of the next byte to load; interrupts only */

void spi_slave_begin(const uint8_t first[FRAME_LENGTH])
{
    memcpy(statuses[0], first, FRAME_LENGTH);
    SPI_DDR |= SPI_MISO;
    SPCR = _BV(SPE) | _BV(SPIE); /* slave, mode 0 */
    SPDR = FRAME_SYNC_1;
    position = 1;
}

bool spi_slave_take(uint8_t *byte)
{
    uint8_t at = tail;

    if (at == head) {
        return false;
    }
    *byte = ring[at];
    tail = (uint8_t)(at + 1U);
    return true;
}

bool spi_slave_paused(void)
{
    bool paused = false;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (head == tail) {
            paused = is_paused;
            is_paused = false;
        }
    }
    return paused;
}

uint8_t *spi_slave_draft(void)
{
    uint8_t in_use = sent; /* may become the offered one meanwhile, which is left alone too */

    draft = 0;
    while (draft == in_use || draft == offered) {
        draft++;
    }
    return statuses[draft];
}

void spi_slave_offer(void)
{
    offered = draft;
}

uint16_t spi_slave_lost(void)
{
    uint16_t count;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        count = lost;
    }
    return count;
}

/* A write while the master already sends is refused by the hardware; then that exchange is lost. */
void spi_slave_millisecond(void)
{
    if (silent_ms >= PAUSE_MS) {
        return;
    }
    silent_ms++;
    if (silent_ms == PAUSE_MS) {
        is_paused = true;
        SPDR = FRAME_SYNC_1;
        position = 1;
    }
}

/*
 * Takes a byte and loads the next. Refuses to look at what it takes: frames are found by the main
 * loop. Budget 128 cycles; docs/firmware.md states what was measured.
 */
ISR(SPI_STC_vect)
{
    uint8_t byte = SPDR;
    uint8_t next = position;
    uint8_t at = head;
    uint8_t after = (uint8_t)(at + 1U);

    if (next == 1) {
        sent = offered;
    }
    if (next < FRAME_LENGTH) {
        SPDR = statuses[sent][next];
        position = (uint8_t)(next + 1U);
    } else {
        SPDR = 0;
    }
    silent_ms = 0;
    if (after != tail) {
        ring[at] = byte;
        head = after;
    } else if (lost != UINT16_MAX) {
        lost++;
    }
}
