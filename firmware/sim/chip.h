/*
 * The ATmega128 that runs the hex file, cycle by cycle (simavr), on its board: three LM629 with
 * motors and encoders, the board of the range sensors, floor sensors, battery, display, switches.
 * There is one chip in a process.
 *
 * simavr does not model chip select, bit timing and write collisions of the SPI: here a byte is
 * there at once, a byte every 256 cycles, and one that finds the last one unread is counted.
 */
#ifndef CHIP_H
#define CHIP_H

#include <stdbool.h>
#include <stdint.h>

#include "lcd_model.h"
#include "rig.h"

enum {
    CHIP_CYCLES_A_BYTE = 256,
    CHIP_RANGES = 3,
    CHIP_FLOOR_SENSORS = 5,
    CHIP_VECTORS = 35,
};

/* What surrounds the robot, and what goes wrong. */
struct surroundings {
    uint16_t range_mm[CHIP_RANGES];
    bool is_range_board_silent;
    bool is_floor_gone[CHIP_FLOOR_SENSORS];
    uint16_t battery_mv;
    bool is_hot;
    bool is_stop_pressed;
    bool is_hung; /* the program does nothing any more, until the watchdog resets the chip */
};

/*
 * The chip is switched on. Returns false, after a line on standard error, when a file cannot be
 * used; eeprom_file: is made where there is none.
 */
bool chip_begin(const char *hex_file, const char *eeprom_file, uint32_t hertz);

struct surroundings *chip_surroundings(void);
struct rig *chip_rig(void);
const struct lcd_model *chip_lcd(void);

/* Microseconds since the start. */
uint64_t chip_us(void);

void chip_run_us(uint32_t us);

/* Sends bytes to the SPI slave and puts the bytes that come back in their place. */
void chip_exchange(uint8_t *bytes, uint16_t length);

/* When the last exchange ended, and when a wheel last turned faster than 10 mm/s at its rim. */
uint64_t chip_exchanged_us(void);
uint64_t chip_moved_us(void);

/* Bytes that came while the interrupt had not yet taken the one before. */
uint32_t chip_overrun_bytes(void);

/* The most cycles from an interrupt's beginning to its return; 0 for one that never came. */
uint32_t chip_longest_interrupt(uint8_t vector);

#endif
