#include "power_cycle.h"

#include <avr/eeprom.h>

static uint16_t EEMEM starts = UINT16_MAX;

/* An erased EEPROM reads 0xFFFF; 0 is skipped when the count wraps around. */
uint16_t power_cycle_count(void)
{
    uint16_t last = eeprom_read_word(&starts);
    uint16_t now = (uint16_t)(last >= UINT16_MAX - 1U ? 1U : last + 1U);

    eeprom_update_word(&starts, now);
    return now;
}
