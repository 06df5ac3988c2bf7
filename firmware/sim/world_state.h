/* The true state of the simulated robot as text, and changes of its surroundings by text. */
#ifndef WORLD_STATE_H
#define WORLD_STATE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes a line of name=value pairs, with its line feed. */
void world_state_write(char *line, size_t size);

/* order: such as "floor 2 gone". Returns whether it was understood. */
bool world_state_change(const char *order);

#endif
