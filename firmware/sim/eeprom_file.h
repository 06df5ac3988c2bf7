/* Keeps the chip's EEPROM in a file, since it outlives the power. */
#ifndef EEPROM_FILE_H
#define EEPROM_FILE_H

#include <simavr/sim_avr.h>
#include <stdbool.h>

/* Takes what the file holds; a file that is not there is an erased EEPROM. */
bool eeprom_file_begin(avr_t *chip, const char *path);

/* Writes the file if the EEPROM has changed. */
void eeprom_file_keep(void);

#endif
