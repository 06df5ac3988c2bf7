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

/* Silence: set to 0 by the SPI interrupt, counted by the clock's, which also notices its end. */
static volatile uint8_t silent_ms;
static volatile bool is_paused; /* set by the clock's interrupt, reset by the main loop */
static volatile uint8_t pause_at; /* the end of what came before it, in the ring */

/*
 * Three statuses: the interrupt sends one, one is offered for the next exchange, the main loop
 * writes another. So there is always a whole one to send, also for a master whose exchanges fall
 * into the writing every time.
 */
static uint8_t statuses[3][FRAME_LENGTH];
static volatile uint8_t sent;    /* written by the interrupt, between exchanges only */
static volatile uint8_t offered; /* written by the main loop */
static uint8_t draft;            /* main loop only */

/* Interrupts only: the byte to load when the next one has come, and the place of the one after. */
static volatile uint8_t answer __attribute__((used));
static volatile uint8_t position;

/* Loads the first byte of a status and holds the second one ready: the sync, whichever it is. */
static inline void load_beginning(void)
{
    SPDR = FRAME_SYNC_1;
    answer = FRAME_SYNC_2;
    position = FRAME_KIND;
}

void spi_slave_begin(const uint8_t first[FRAME_LENGTH])
{
    memcpy(statuses[0], first, FRAME_LENGTH);
    SPI_DDR |= SPI_MISO;
    SPCR = _BV(SPE) | _BV(SPIE); /* slave, mode 0 */
    load_beginning();
}

bool spi_slave_take_byte(uint8_t *byte)
{
    uint8_t at = tail;

    if (at == head || (is_paused && at == pause_at)) {
        return false;
    }
    *byte = ring[at];
    tail = (uint8_t)(at + 1U);
    return true;
}

bool spi_slave_take_pause(void)
{
    bool paused = false;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (is_paused && tail == pause_at) {
            is_paused = false;
            paused = true;
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

uint16_t spi_slave_lost_bytes(void)
{
    uint16_t count;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        count = lost;
    }
    return count;
}

/* A write while the master already sends is refused by the hardware; then that exchange is lost. */
void spi_slave_on_millisecond(void)
{
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (silent_ms < PAUSE_MS && ++silent_ms == PAUSE_MS) {
            is_paused = true;
            pause_at = head;
            load_beginning();
        }
    }
}

static inline void prepare_answer(void)
{
    uint8_t at = position;

    if (at == FRAME_KIND) {
        sent = offered;
    }
    if (at < FRAME_LENGTH) {
        answer = statuses[sent][at];
        position = (uint8_t)(at + 1U);
    } else {
        answer = 0;
    }
}

static inline void put(uint8_t byte)
{
    uint8_t at = head;
    uint8_t after = (uint8_t)(at + 1U);

    if (after != tail) {
        ring[at] = byte;
        head = after;
    } else if (lost != UINT16_MAX) {
        lost++;
    }
}

/*
 * Takes the byte that came, and prepares an answer. Does not interpret what it takes: frames are
 * found by the main loop.
 */
ISR(__vector_take_byte)
{
    silent_ms = 0;
    put(SPDR);
    prepare_answer();
}

/*
 * Loads the answer, first of all and before anything is saved: that must be done 192 cycles after
 * the byte came, when the master may shift again. Budget 128 cycles, with what it goes on to;
 * docs/firmware.md states what was measured.
 */
ISR(SPI_STC_vect, ISR_NAKED)
{
    __asm__ volatile("push r24\n\t"
                     "lds  r24, answer\n\t"
                     "out  %[spdr], r24\n\t"
                     "pop  r24\n\t"
                     "rjmp __vector_take_byte"
                     :
                     : [spdr] "I"(_SFR_IO_ADDR(SPDR)));
}
