#include "settings_store.h"

#include <avr/eeprom.h>
#include <stddef.h>
#include <string.h>

#include "crc16.h"

/* The check sum comes last, and is wrong until all bytes before it are written. */
struct record {
    struct settings settings;
    struct arm_settings arm;
    uint16_t crc;
};

static struct record EEMEM kept;

static uint16_t crc_of(const struct record *record)
{
    return crc16((const uint8_t *)record, offsetof(struct record, crc));
}

void settings_store_read(struct settings *settings, struct arm_settings *arm)
{
    struct record record;
    bool is_intact;

    eeprom_read_block(&record, &kept, sizeof record);
    is_intact = record.crc == crc_of(&record);
    *settings = is_intact && settings_are_good(&record.settings) ? record.settings
                                                                 : settings_default();
    memset(arm, 0, sizeof *arm);
    if (is_intact && arm_settings_are_good(&record.arm)) {
        *arm = record.arm;
    }
}

void settings_store_step(const struct settings *settings, const struct arm_settings *arm)
{
    static struct record wanted;
    static uint8_t at = sizeof wanted; /* the byte to be looked at next */
    uint8_t *place = (uint8_t *)&kept + at;

    if (!settings_are_same(settings, &wanted.settings) ||
        !arm_settings_are_same(arm, &wanted.arm)) {
        memset(&wanted, 0, sizeof wanted);
        wanted.settings = *settings;
        wanted.arm = *arm;
        wanted.crc = crc_of(&wanted);
        at = 0;
    } else if (at < sizeof wanted && eeprom_is_ready()) {
        eeprom_update_byte(place, ((const uint8_t *)&wanted)[at]);
        at++;
    }
}
