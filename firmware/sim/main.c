/* toqa-sim: the firmware's hex file in a simulated ATmega128 on its simulated board. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chip.h"
#include "server.h"

enum { WRONG_ARGUMENTS = 2 };

int main(int count, char **arguments)
{
    unsigned long hertz = count == 5 ? strtoul(arguments[4], NULL, 10) : 16000000;

    if (count < 4 || count > 5 || hertz < 1000000 || hertz > 20000000) {
        fprintf(stderr, "usage: toqa-sim HEX SOCKET EEPROM [F_CPU]\n");
        return WRONG_ARGUMENTS;
    }
    if (!chip_begin(arguments[1], arguments[3], (uint32_t)hertz)) {
        return 1;
    }
    return server_run(arguments[2]);
}
