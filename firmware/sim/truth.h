/* The truth about the simulated robot as text, and changes of its surroundings by text. */
#ifndef TRUTH_H
#define TRUTH_H

#include <stdbool.h>
#include <stddef.h>

/* Writes a line of name=value pairs, with its line feed. */
void truth_write(char *line, size_t size);

/* order: such as "floor 2 gone". Returns whether it was understood. */
bool truth_change(const char *order);

#endif
