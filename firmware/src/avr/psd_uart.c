#include "psd_uart.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#define BAUD 38400UL
#include <util/setbaud.h>

_Static_assert(!USE_2X, "the UART is not set to double speed");

enum { RING = 32 }; /* two messages and more; a power of two */

/* Head written by the interrupt, tail by the main loop. */
static volatile uint8_t ring[RING];
static volatile uint8_t head;
static volatile uint8_t tail;

void psd_uart_begin(void)
{
    UBRR1H = UBRRH_VALUE;
    UBRR1L = UBRRL_VALUE;
    UCSR1C = _BV(UCSZ11) | _BV(UCSZ10); /* 8 bits, no parity */
    UCSR1B = _BV(RXCIE1) | _BV(RXEN1);
}

static inline void put(uint8_t byte)
{
    uint8_t at = head;
    uint8_t after = (uint8_t)((at + 1U) % RING);

    if (after != tail) {
        ring[at] = byte;
        head = after;
    }
}

bool psd_uart_take_byte(uint8_t *byte)
{
    uint8_t at = tail;

    if (at == head) {
        return false;
    }
    *byte = ring[at];
    tail = (uint8_t)((at + 1U) % RING);
    return true;
}

/*
 * Takes a byte. One for which there is no room is dropped: the sum of its message will be wrong.
 * Once it has the byte it is interrupted by all others; docs/firmware.md states what was measured.
 */
ISR(USART1_RX_vect)
{
    uint8_t byte = UDR1;

    sei();
    put(byte);
}
