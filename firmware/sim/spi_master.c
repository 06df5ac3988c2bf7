#include "spi_master.h"

#include <simavr/avr_spi.h>
#include <stddef.h>

#include "interrupt_meter.h"

enum {
    SPSR_ADDRESS = 0x2E,
    SPDR_ADDRESS = 0x2F,
    SPIF = 0x80,
    SPI_VECTOR = 17,
};

static avr_t *chip;

static struct {
    uint8_t *bytes;
    uint16_t length;
    uint16_t sent;
    bool is_shifting;
} master;

static struct {
    uint8_t shift_register;
    bool is_ready; /* it was written since the last byte came */
    avr_cycle_count_t came;
} slave;

static uint32_t overruns;
static uint32_t late_answers;
static uint32_t longest_answer;

/* In an exchange only: at its end the chip may wait until the next one. */
static void measure_answer(void)
{
    uint32_t cycles = (uint32_t)(chip->cycle - slave.came);

    if (master.sent < master.length && cycles > longest_answer) {
        longest_answer = cycles;
    }
}

static void on_answer(avr_t *avr, avr_io_addr_t address, uint8_t value, void *parameter)
{
    (void)avr;
    (void)address;
    (void)parameter;
    if (master.is_shifting) {
        return;
    }
    if (!slave.is_ready) {
        measure_answer();
    }
    slave.shift_register = value;
    slave.is_ready = true;
}

static void begin_byte(void)
{
    master.is_shifting = true;
    late_answers += !slave.is_ready;
}

static void end_byte(void)
{
    uint8_t byte = master.bytes[master.sent];
    bool is_unread = (chip->data[SPSR_ADDRESS] & SPIF) != 0 || interrupt_meter_runs(SPI_VECTOR);

    overruns += is_unread;
    master.bytes[master.sent] = slave.shift_register;
    master.sent++;
    master.is_shifting = false;
    slave.shift_register = byte;
    slave.is_ready = false;
    slave.came = chip->cycle;
    avr_raise_irq(avr_io_getirq(chip, AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_INPUT), byte);
}

static avr_cycle_count_t clock_bits(avr_t *avr, avr_cycle_count_t when, void *parameter)
{
    (void)avr;
    (void)parameter;
    if (!master.is_shifting) {
        begin_byte();
        return when + SPI_MASTER_CYCLES_OF_BITS;
    }
    end_byte();
    return master.sent == master.length
               ? 0
               : when + SPI_MASTER_CYCLES_A_BYTE - SPI_MASTER_CYCLES_OF_BITS;
}

void spi_master_wire(avr_t *avr)
{
    chip = avr;
    avr_register_io_write(avr, SPDR_ADDRESS, on_answer, NULL);
}

void spi_master_send(uint8_t *bytes, uint16_t length)
{
    master.bytes = bytes;
    master.length = length;
    master.sent = 0;
    master.is_shifting = false;
    avr_cycle_timer_register(chip, 1, clock_bits, NULL);
}

uint32_t spi_master_overruns(void)
{
    return overruns;
}

uint32_t spi_master_late_answers(void)
{
    return late_answers;
}

uint32_t spi_master_longest_answer(void)
{
    return longest_answer;
}
