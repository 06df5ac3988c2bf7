#include "chip.h"

#include <math.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_time.h>
#include <simavr/sim_hex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arm_board.h"
#include "board_model.h"
#include "eeprom_file.h"
#include "interrupt_meter.h"
#include "load_meter.h"
#include "spi_master.h"

enum {
    SUPPLY_MV = 5000,
    FEEL_PERIOD_US = 1000,
    HANG_LENGTH = 2,
};

static const double STOPPED_M_S = 0.010; /* at the rim */

static avr_t *avr;
static const struct drive_model *drive;
static struct rig rig;
static struct lcd_model lcd;
static struct surroundings surroundings;
static struct board_model board;

static uint64_t steps; /* of the motors */
static uint64_t exchanged_us;
static uint64_t moved_us;

static struct {
    bool is_hung;
    avr_flashaddr_t at;
    uint8_t instruction[HANG_LENGTH]; /* that is there else */
} hung;

static avr_cycle_count_t turn_rig(avr_t *chip, avr_cycle_count_t when, void *parameter)
{
    (void)when;
    (void)parameter;
    steps++;
    drive->turn();
    if (rig_fastest_rim(&rig) > STOPPED_M_S) {
        moved_us = chip_us();
    }
    return (avr_cycle_count_t)llround((double)(steps + 1) * drive->seconds *
                                      chip->frequency);
}

static avr_cycle_count_t feel(avr_t *chip, avr_cycle_count_t when, void *parameter)
{
    (void)parameter;
    board_model_update(&board);
    return when + avr_usec_to_cycles(chip, FEEL_PERIOD_US);
}

/* simavr forgets all timers when the chip is reset. */
static void begin_timers(void)
{
    avr_cycle_timer_register(avr, 1, turn_rig, NULL);
    avr_cycle_timer_register_usec(avr, FEEL_PERIOD_US, feel, NULL);
}

/* Else simavr would let real time pass while the program sleeps. */
static void do_not_sleep(avr_t *chip, avr_cycle_count_t cycles)
{
    (void)chip;
    (void)cycles;
}

/* simavr tells what it thinks of the program; only errors are for people. */
static void say_errors_only(avr_t *chip, const int level, const char *format, va_list arguments)
{
    (void)chip;
    if (level == LOG_ERROR) {
        vfprintf(stderr, format, arguments);
    }
}

static bool load(const char *hex_file)
{
    uint32_t size = 0;
    uint32_t base = 0;
    uint8_t *code = read_ihex_file(hex_file, &size, &base);

    if (code == NULL || size == 0) {
        fprintf(stderr, "toqa-sim: %s is no hex file that can be read.\n", hex_file);
        return false;
    }
    avr_loadcode(avr, code, size, base);
    avr->codeend = avr->flashend;
    free(code);
    return true;
}

bool chip_begin(const char *hex_file, const char *eeprom_file, uint32_t hertz,
                const struct drive_model *its_drive)
{
    avr_global_logger_set(say_errors_only);
    avr = avr_make_mcu_by_name("atmega128");
    if (avr == NULL) {
        fprintf(stderr, "toqa-sim: simavr knows no ATmega128.\n");
        return false;
    }
    avr_init(avr);
    avr->frequency = hertz;
    avr->vcc = avr->avcc = avr->aref = SUPPLY_MV;
    avr->sleep = do_not_sleep;
    if (!load(hex_file) || !eeprom_file_begin(avr, eeprom_file)) {
        return false;
    }
    surroundings = (struct surroundings){.range_mm = {800, 800, 800},
                                         .floor_mv = {3000, 3000, 3000, 3000, 3000},
                                         .temperature = 25,
                                         .battery_mv = 16000};
    lcd_model_begin(&lcd);
    board = (struct board_model){.avr = avr, .lcd = &lcd, .surroundings = &surroundings};
    board_model_wire(&board);
    arm_board_wire(avr);
    drive = its_drive;
    drive->wire(avr, &rig);
    spi_master_wire(avr);
    interrupt_meter_begin(avr);
    begin_timers();
    return true;
}

struct surroundings *chip_surroundings(void)
{
    return &surroundings;
}

struct rig *chip_rig(void)
{
    return &rig;
}

const struct lcd_model *chip_lcd(void)
{
    return &lcd;
}

uint64_t chip_us(void)
{
    return (uint64_t)((double)avr->cycle * 1e6 / avr->frequency);
}

/* Puts "jump to here" where the program is, until the watchdog resets the chip. */
static void hang(void)
{
    static const uint8_t jump_to_here[HANG_LENGTH] = {0xFF, 0xCF};

    if (hung.is_hung || avr->state != cpu_Running) {
        return;
    }
    hung.is_hung = true;
    hung.at = avr->pc;
    memcpy(hung.instruction, avr->flash + hung.at, HANG_LENGTH);
    memcpy(avr->flash + hung.at, jump_to_here, HANG_LENGTH);
    avr->sreg[S_I] = 0;
}

static void on_reset(void)
{
    begin_timers();
    board_model_restart(&board);
    arm_board_restart();
    drive->restart();
    interrupt_meter_restart();
    load_meter_restart();
    if (hung.is_hung) {
        memcpy(avr->flash + hung.at, hung.instruction, HANG_LENGTH);
        hung.is_hung = false;
        surroundings.is_hung = false;
    }
}

static void run_until(avr_cycle_count_t cycle)
{
    while (avr->cycle < cycle) {
        avr_cycle_count_t begun = avr->cycle;
        int before = avr->state;
        int state = avr_run(avr);

        load_meter_step(avr, begun, before);
        if (state == cpu_Done || state == cpu_Crashed) {
            fprintf(stderr, "toqa-sim: the program ended at %#x.\n", avr->pc);
            exit(1);
        }
        if (avr->pc == 0) {
            on_reset();
        } else if (surroundings.is_hung) {
            hang();
        }
    }
}

void chip_run_us(uint32_t us)
{
    run_until(avr->cycle + avr_usec_to_cycles(avr, us));
    eeprom_file_keep();
}

void chip_exchange(uint8_t *bytes, uint16_t length)
{
    avr_cycle_count_t cycles = (avr_cycle_count_t)length * SPI_MASTER_CYCLES_A_BYTE;

    spi_master_send(bytes, length);
    run_until(avr->cycle + cycles);
    exchanged_us = chip_us();
}

uint32_t chip_exchange_us(uint16_t length)
{
    return avr_cycles_to_usec(avr, (avr_cycle_count_t)length * SPI_MASTER_CYCLES_A_BYTE);
}

uint64_t chip_exchanged_us(void)
{
    return exchanged_us;
}

uint64_t chip_moved_us(void)
{
    return moved_us;
}
