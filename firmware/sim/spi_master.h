/*
 * The master of the SPI, at the highest rate that docs/spi-frame.md allows: a byte every 256
 * cycles, whose bits take 64. simavr knows no shift register; here is one: what the chip writes
 * while bits are shifted is refused, and a byte for which it has nothing ready is answered by the
 * byte that it received last. simavr has no chip select either.
 */
#ifndef SPI_MASTER_H
#define SPI_MASTER_H

#include <simavr/sim_avr.h>

enum {
    SPI_MASTER_CYCLES_A_BYTE = 256,
    SPI_MASTER_CYCLES_OF_BITS = 64,
};

void spi_master_wire(avr_t *avr);

/* Begins to send bytes, and puts the bytes that come back in their place. */
void spi_master_send(uint8_t *bytes, uint16_t length);

/* Bytes that came while the interrupt had not yet taken the one before. */
uint32_t spi_master_overruns(void);

/* Bytes for which the chip had no answer ready when their first bit was shifted. */
uint32_t spi_master_late_answers(void);

/* The most cycles from the last bit of a byte until the chip had the next answer ready. */
uint32_t spi_master_longest_answer(void);

#endif
