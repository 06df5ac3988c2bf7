#include "eeprom_file.h"

#include <simavr/avr_eeprom.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { SIZE = 4096 };

static const uint8_t *eeprom;
static uint8_t kept[SIZE];
static const char *file;

bool eeprom_file_begin(avr_t *chip, const char *path)
{
    avr_eeprom_desc_t content = {.ee = kept, .offset = 0, .size = SIZE};
    avr_eeprom_desc_t inside = {.ee = NULL, .offset = 0, .size = SIZE};
    FILE *stream = fopen(path, "rb");
    bool is_whole = true;

    file = path;
    memset(kept, 0xFF, SIZE);
    if (stream != NULL) {
        is_whole = fread(kept, 1, SIZE, stream) == SIZE;
        fclose(stream);
    }
    if (!is_whole) {
        fprintf(stderr, "toqa-sim: %s does not hold an EEPROM.\n", path);
        return false;
    }
    avr_ioctl(chip, AVR_IOCTL_EEPROM_SET, &content);
    avr_ioctl(chip, AVR_IOCTL_EEPROM_GET, &inside);
    eeprom = inside.ee;
    return true;
}

void eeprom_file_keep(void)
{
    FILE *stream;

    if (memcmp(eeprom, kept, SIZE) == 0) {
        return;
    }
    stream = fopen(file, "wb");
    if (stream == NULL) {
        fprintf(stderr, "toqa-sim: cannot write %s.\n", file);
        return;
    }
    memcpy(kept, eeprom, SIZE);
    fwrite(kept, 1, SIZE, stream);
    fclose(stream);
}
