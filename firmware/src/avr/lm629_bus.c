#include "lm629_bus.h"

#include <util/delay.h>

#include "board.h"
#include "drive_bus.h"

/* The control lines at rest: all high. */
static void rest(void)
{
    LM629_CONTROL_PORT = LM629_CONTROL_PINS;
}

void lm629_bus_reset(void)
{
    rest();
    LM629_CONTROL_DDR = LM629_CONTROL_PINS;
    LM629_CONTROL_PORT = (uint8_t)(LM629_CONTROL_PINS & ~LM629_RST);
    _delay_us(10);
    rest();
    _delay_ms(2);
}

/* WR low for 100 ns or more: three cycles at 16 MHz. */
static void put(uint8_t axis, uint8_t select, uint8_t byte)
{
    uint8_t lines = (uint8_t)(LM629_CONTROL_PINS & ~LM629_CS(axis) & ~select);

    LM629_DATA_DDR = 0xFF;
    LM629_DATA_PORT = byte;
    LM629_CONTROL_PORT = lines;
    LM629_CONTROL_PORT = (uint8_t)(lines & ~LM629_WR);
    _delay_us(0.2);
    LM629_CONTROL_PORT = lines;
    rest();
}

/* The data is there 180 ns after RD went low, and a cycle more until the pins are sampled. */
static uint8_t get(uint8_t axis, uint8_t select)
{
    uint8_t lines = (uint8_t)(LM629_CONTROL_PINS & ~LM629_CS(axis) & ~select);
    uint8_t byte;

    LM629_DATA_DDR = 0;
    LM629_CONTROL_PORT = lines;
    LM629_CONTROL_PORT = (uint8_t)(lines & ~LM629_RD);
    _delay_us(0.3);
    byte = LM629_DATA_PIN;
    rest();
    return byte;
}

void lm629_bus_command(uint8_t axis, uint8_t command)
{
    put(axis, LM629_PS, command);
}

void lm629_bus_write(uint8_t axis, uint8_t data)
{
    put(axis, 0, data);
}

uint8_t lm629_bus_status(uint8_t axis)
{
    return get(axis, LM629_PS);
}

uint8_t lm629_bus_read(uint8_t axis)
{
    return get(axis, 0);
}

/* The controllers have a clock of their own. */
void drive_bus_on_millisecond(void)
{
}
