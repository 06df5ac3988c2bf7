/* Keeps the settings of robot and arm in the EEPROM. */
#ifndef SETTINGS_STORE_H
#define SETTINGS_STORE_H

#include "arm_settings.h"
#include "settings.h"

/* Reads those that are kept; where there are none, those of a robot that nobody has measured. */
void settings_store_read(struct settings *settings, struct arm_settings *arm);

/* To be called again and again: writes at most one byte, and never waits for the EEPROM. */
void settings_store_step(const struct settings *settings, const struct arm_settings *arm);

#endif
