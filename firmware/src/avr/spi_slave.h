/*
 * The slave's end of docs/spi-frame.md: bytes come into a ring, the newest status goes out. All by
 * interrupt; nothing here waits.
 */
#ifndef SPI_SLAVE_H
#define SPI_SLAVE_H

#include <stdbool.h>
#include <stdint.h>

#include "frame.h"

/* first: what is sent until spi_slave_offer is called. */
void spi_slave_begin(const uint8_t first[FRAME_LENGTH]);

/* Returns whether there was a byte. None is behind a pause that is not taken yet. */
bool spi_slave_take_byte(uint8_t *byte);

/* Returns, once, whether the master made a pause after the bytes taken so far. */
bool spi_slave_take_pause(void);

/* Where the next status is to be written, and that it is written. */
uint8_t *spi_slave_draft(void);
void spi_slave_offer(void);

/* Bytes for which the ring had no room; stays at 65535. */
uint16_t spi_slave_lost_bytes(void);

/* For the interrupt of the clock only. */
void spi_slave_on_millisecond(void);

#endif
