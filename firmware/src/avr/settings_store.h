/* Keeps the settings in the EEPROM. */
#ifndef SETTINGS_STORE_H
#define SETTINGS_STORE_H

#include "settings.h"

/* Those that are kept; those of a robot that nobody has measured where there are none. */
struct settings settings_store_read(void);

/* To be called again and again: writes at most one byte, and never waits for the EEPROM. */
void settings_store_step(const struct settings *settings);

#endif
