#include "world_state.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "arm_board.h"
#include "chip.h"
#include "interrupt_meter.h"
#include "lm629_board.h"
#include "load_meter.h"
#include "spi_master.h"

/* Puts a piece of the line behind the others. */
#define ADD(...) at += snprintf(line + at, at < (int)size ? size - (size_t)at : 0, __VA_ARGS__)

static const struct {
    const char *name;
    uint8_t vector;
} INTERRUPTS[] = {
    {"encoder1_cycles", 5}, {"encoder2_cycles", 6}, {"encoder3_cycles", 7},
    {"clock_cycles", 15},   {"spi_cycles", 17},     {"uart_cycles", 30},
};

static uint32_t rudenesses(void)
{
    uint32_t sum = 0;

    for (int i = 0; i < RIG_WHEELS; i++) {
        sum += lm629_board_controllers()[i].rudenesses;
    }
    return sum;
}

void world_state_write(char *line, size_t size)
{
    const struct rig *rig = chip_rig();
    const struct lcd_model *lcd = chip_lcd();
    int at = 0;

    ADD("us=%" PRIu64 " exchanged_us=%" PRIu64 " moved_us=%" PRIu64, chip_us(),
        chip_exchanged_us(), chip_moved_us());
    ADD(" x=%.6f y=%.6f theta=%.6f rim=%.6f", rig->x, rig->y, rig->theta, rig_fastest_rim(rig));
    for (int i = 0; i < RIG_WHEELS; i++) {
        ADD(" counts%d=%.3f", i + 1, rig->motors[i].angle);
    }
    for (int i = 0; i < ARM_BOARD_SERVOS; i++) {
        ADD(" servo%d=%.6f", i + 1, arm_board.shares[i]);
    }
    ADD(" load_g=%" PRIu32 " grasps=%" PRIu32 " releases=%" PRIu32 " cut_pulses=%" PRIu32,
        arm_board.load_g, arm_board.grasps, arm_board.releases, arm_board.cut_pulses);
    ADD(" overruns=%" PRIu32 " late_answers=%" PRIu32 " answer_cycles=%" PRIu32, spi_master_overruns(),
        spi_master_late_answers(), spi_master_longest_answer());
    for (size_t i = 0; i < sizeof INTERRUPTS / sizeof INTERRUPTS[0]; i++) {
        ADD(" %s=%" PRIu32, INTERRUPTS[i].name, interrupt_meter_longest(INTERRUPTS[i].vector));
    }
    ADD(" busiest_us=%" PRIu32 " awake_us=%" PRIu32 " rudenesses=%" PRIu32, load_meter_take_busiest_us(),
        load_meter_take_longest_us(), rudenesses());
    ADD(" lcd1=\"%s\" lcd2=\"%s\"\n", lcd->lines[0], lcd->lines[1]);
}

static bool change_numbered(const char *what, unsigned number, const char *how)
{
    if (strcmp(what, "floor") == 0 && number < CHIP_FLOOR_SENSORS) {
        chip_surroundings()->is_floor_gone[number] = strcmp(how, "gone") == 0;
        return true;
    }
    if (strcmp(what, "floor_mv") == 0 && number < CHIP_FLOOR_SENSORS) {
        return sscanf(how, "%" SCNu16, &chip_surroundings()->floor_mv[number]) == 1;
    }
    if (strcmp(what, "switch") == 0 && number >= 2 && number < 2 + CHIP_SWITCHES) {
        chip_surroundings()->is_switch_pressed[number - 2] = strcmp(how, "pressed") == 0;
        return true;
    }
    if (strcmp(what, "wheel") == 0 && number < RIG_WHEELS) {
        chip_rig()->motors[number].is_blocked = strcmp(how, "blocked") == 0;
        chip_rig()->motors[number].is_pushed = strcmp(how, "pushed") == 0;
        return true;
    }
    if (strcmp(what, "size") == 0 && number < RIG_WHEELS) {
        int ppm;

        if (sscanf(how, "%d", &ppm) != 1) {
            return false;
        }
        chip_rig()->motors[number].larger = ppm * 1e-6;
        return true;
    }
    if (strcmp(what, "controller") == 0 && number < RIG_WHEELS) {
        lm629_board_controllers()[number].is_dead = strcmp(how, "dead") == 0;
        return true;
    }
    if (strcmp(what, "range") == 0 && number < CHIP_RANGES) {
        return sscanf(how, "%" SCNu16, &chip_surroundings()->range_mm[number]) == 1;
    }
    return false;
}

static bool load(const char *percent)
{
    unsigned share;

    if (sscanf(percent, "%u", &share) != 1) {
        return false;
    }
    for (int i = 0; i < RIG_WHEELS; i++) {
        chip_rig()->motors[i].load = share / 100.0;
    }
    return true;
}

static bool change(const char *what, const char *how)
{
    struct surroundings *surroundings = chip_surroundings();
    const struct {
        const char *what;
        const char *how;
        bool *flag;
    } flags[] = {
        {"heat", "on", &surroundings->is_hot},
        {"switch", "pressed", &surroundings->is_stop_pressed},
        {"ranges", "silent", &surroundings->is_range_board_silent},
        {"program", "hung", &surroundings->is_hung},
        {"arm", "stuck", &arm_board.is_stuck},
    };

    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        if (strcmp(what, flags[i].what) == 0) {
            *flags[i].flag = strcmp(how, flags[i].how) == 0;
            return true;
        }
    }
    if (strcmp(what, "load") == 0) {
        return load(how);
    }
    if (strcmp(what, "box") == 0) {
        return sscanf(how, "%" SCNu32, &arm_board.box_g) == 1;
    }
    if (strcmp(what, "temperature") == 0) {
        return sscanf(how, "%" SCNd16, &surroundings->temperature) == 1;
    }
    return strcmp(what, "battery") == 0 && sscanf(how, "%" SCNu16, &surroundings->battery_mv) == 1;
}

bool world_state_change(const char *order)
{
    char what[16];
    char how[16];
    unsigned number;

    if (sscanf(order, "%15s %u %15s", what, &number, how) == 3) {
        return change_numbered(what, number, how);
    }
    return sscanf(order, "%15s %15s", what, how) == 2 && change(what, how);
}
