/*
 * The ATmega128 that runs the hex file, cycle by cycle (simavr), on its board: motors with encoders
 * and one of the drives, the board of the range sensors, floor sensors, battery, display, switches.
 * There is one chip in a process.
 */
#ifndef CHIP_H
#define CHIP_H

#include <stdbool.h>
#include <stdint.h>

#include "drive_model.h"
#include "lcd_model.h"
#include "rig.h"

enum { CHIP_RANGES = 3, CHIP_FLOOR_SENSORS = 5, CHIP_SWITCHES = 3 };

/* What surrounds the robot, and what goes wrong. */
struct surroundings {
    uint16_t range_mm[CHIP_RANGES];
    bool is_range_board_silent;
    bool is_floor_gone[CHIP_FLOOR_SENSORS];
    uint16_t floor_mv[CHIP_FLOOR_SENSORS]; /* where there is a floor */
    bool is_switch_pressed[CHIP_SWITCHES]; /* switches 2 to 4 */
    int16_t temperature;                   /* degrees Celsius */
    uint16_t battery_mv;
    bool is_hot;
    bool is_stop_pressed;
    bool is_hung; /* the program does nothing any more, until the watchdog resets the chip */
};

/*
 * The chip is switched on. Returns false, after a line on standard error, when a file cannot be
 * used; eeprom_file: is made where there is none.
 */
bool chip_begin(const char *hex_file, const char *eeprom_file, uint32_t hertz,
                const struct drive_model *drive);

struct surroundings *chip_surroundings(void);
struct rig *chip_rig(void);
const struct lcd_model *chip_lcd(void);

/* Microseconds since the start. */
uint64_t chip_us(void);

void chip_run_us(uint32_t us);

/* Sends bytes to the SPI slave and puts the bytes that come back in their place. */
void chip_exchange(uint8_t *bytes, uint16_t length);

/* How long that takes. */
uint32_t chip_exchange_us(uint16_t length);

/* When the last exchange ended, and when a wheel last turned faster than 10 mm/s at its rim. */
uint64_t chip_exchanged_us(void);
uint64_t chip_moved_us(void);

#endif
