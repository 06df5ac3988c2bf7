/* The display: an HD44780 with 2 x 20 characters on four data lines. */
#ifndef LCD_MODEL_H
#define LCD_MODEL_H

#include <stdbool.h>
#include <stdint.h>

enum { LCD_MODEL_LINES = 2, LCD_MODEL_COLUMNS = 20 };

struct lcd_model {
    char lines[LCD_MODEL_LINES][LCD_MODEL_COLUMNS + 1];
    bool is_four_bit;
    bool has_high_half;
    uint8_t high_half;
    uint8_t address;
};

void lcd_model_begin(struct lcd_model *lcd);

/* E falls; nibble: of the four data lines. */
void lcd_model_strobe(struct lcd_model *lcd, bool is_data, uint8_t nibble);

#endif
