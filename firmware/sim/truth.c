#include "truth.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "chip.h"

enum { TIMER0_VECTOR = 15, SPI_VECTOR = 17, UART1_VECTOR = 30 };

void truth_write(char *line, size_t size)
{
    const struct rig *rig = chip_rig();
    const struct lcd_model *lcd = chip_lcd();

    snprintf(line, size,
             "us=%" PRIu64 " exchanged_us=%" PRIu64 " moved_us=%" PRIu64
             " x=%.6f y=%.6f theta=%.6f rim=%.6f overruns=%" PRIu32 " rudenesses=%" PRIu32
             " spi_cycles=%" PRIu32 " clock_cycles=%" PRIu32 " uart_cycles=%" PRIu32
             " lcd1=\"%s\" lcd2=\"%s\"\n",
             chip_us(), chip_exchanged_us(), chip_moved_us(), rig->x, rig->y, rig->theta,
             rig_fastest_rim(rig), chip_overrun_bytes(),
             rig->wheels[0].rudenesses + rig->wheels[1].rudenesses + rig->wheels[2].rudenesses,
             chip_longest_interrupt(SPI_VECTOR), chip_longest_interrupt(TIMER0_VECTOR),
             chip_longest_interrupt(UART1_VECTOR), lcd->lines[0], lcd->lines[1]);
}

static bool change_numbered(const char *what, unsigned number, const char *how)
{
    if (strcmp(what, "floor") == 0 && number < CHIP_FLOOR_SENSORS) {
        chip_surroundings()->is_floor_gone[number] = strcmp(how, "gone") == 0;
        return true;
    }
    if (strcmp(what, "wheel") == 0 && number < RIG_WHEELS) {
        chip_rig()->wheels[number].motor.is_blocked = strcmp(how, "blocked") == 0;
        return true;
    }
    if (strcmp(what, "controller") == 0 && number < RIG_WHEELS) {
        chip_rig()->wheels[number].is_dead = strcmp(how, "dead") == 0;
        return true;
    }
    if (strcmp(what, "range") == 0 && number < CHIP_RANGES) {
        return sscanf(how, "%" SCNu16, &chip_surroundings()->range_mm[number]) == 1;
    }
    return false;
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
    };

    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        if (strcmp(what, flags[i].what) == 0) {
            *flags[i].flag = strcmp(how, flags[i].how) == 0;
            return true;
        }
    }
    return strcmp(what, "battery") == 0 && sscanf(how, "%" SCNu16, &surroundings->battery_mv) == 1;
}

bool truth_change(const char *order)
{
    char what[16];
    char how[16];
    unsigned number;

    if (sscanf(order, "%15s %u %15s", what, &number, how) == 3) {
        return change_numbered(what, number, how);
    }
    return sscanf(order, "%15s %15s", what, how) == 2 && change(what, how);
}
