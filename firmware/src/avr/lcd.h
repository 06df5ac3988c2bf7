/* The display, HD44780 with 2 x 20 characters on four data lines. */
#ifndef LCD_H
#define LCD_H

#include "panel.h"

/* Takes 60 ms. */
void lcd_begin(void);

/* Every millisecond: writes one character; a panel takes 42 ms. Never waits. */
void lcd_step(const struct panel *panel);

#endif
