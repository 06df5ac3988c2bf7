/* toqa-sim: the firmware's hex file in a simulated ATmega128 on its simulated board. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "chip.h"
#include "lm629_board.h"
#include "pwm_board.h"
#include "server.h"

enum { WRONG_ARGUMENTS = 2, SLOWEST_HERTZ = 1000000, FASTEST_HERTZ = 20000000 };

static unsigned long hertz = 16000000;
static const struct drive_model *drive = &lm629_board;

static bool read_drive(const char *name)
{
    if (strcmp(name, "pwm") == 0) {
        drive = &pwm_board;
        return true;
    }
    return strcmp(name, "lm629") == 0;
}

static bool read_options(int count, char **arguments)
{
    int option;

    while ((option = getopt(count, arguments, "c:d:")) != -1) {
        if (option == 'c') {
            hertz = strtoul(optarg, NULL, 10);
        } else if (option != 'd' || !read_drive(optarg)) {
            return false;
        }
    }
    return hertz >= SLOWEST_HERTZ && hertz <= FASTEST_HERTZ && count - optind == 3;
}

int main(int count, char **arguments)
{
    if (!read_options(count, arguments)) {
        fprintf(stderr, "usage: toqa-sim [-c HERTZ] [-d lm629|pwm] HEX SOCKET EEPROM\n"
                        "-c: the chip's clock, 1000000 to 20000000, else 16000000\n"
                        "-d: what drives the motors on its board, else lm629\n");
        return WRONG_ARGUMENTS;
    }
    if (!chip_begin(arguments[optind], arguments[optind + 2], (uint32_t)hertz, drive)) {
        return 1;
    }
    return server_run(arguments[optind + 1]);
}
