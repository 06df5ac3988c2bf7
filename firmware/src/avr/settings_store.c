#include "settings_store.h"

#include <avr/eeprom.h>
#include <stddef.h>
#include <string.h>

#include "crc16.h"

/* The check sum comes last, and is wrong until all bytes before it are written. */
struct record {
    struct settings settings;
    uint16_t crc;
};

static struct record EEMEM kept;

static uint16_t crc_of(const struct record *record)
{
    return crc16((const uint8_t *)record, offsetof(struct record, crc));
}

struct settings settings_store_read(void)
{
    struct record record;

    eeprom_read_block(&record, &kept, sizeof record);
    return record.crc == crc_of(&record) && settings_are_good(&record.settings)
               ? record.settings
               : settings_default();
}

void settings_store_step(const struct settings *settings)
{
    static struct record wanted;
    static uint8_t at = sizeof wanted; /* the byte to be looked at next */
    uint8_t *place = (uint8_t *)&kept + at;

    if (!settings_are_same(settings, &wanted.settings)) {
        memset(&wanted, 0, sizeof wanted);
        wanted.settings = *settings;
        wanted.crc = crc_of(&wanted);
        at = 0;
    } else if (at < sizeof wanted && eeprom_is_ready()) {
        eeprom_update_byte(place, ((const uint8_t *)&wanted)[at]);
        at++;
    }
}
