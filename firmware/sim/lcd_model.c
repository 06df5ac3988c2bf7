#include "lcd_model.h"

#include <string.h>

enum { SECOND_LINE = 0x40, GO_TO = 0x80, CLEAR = 0x01, FUNCTION_4_BIT = 0x2 };

static void clear(struct lcd_model *lcd)
{
    for (int i = 0; i < LCD_MODEL_LINES; i++) {
        memset(lcd->lines[i], ' ', LCD_MODEL_COLUMNS);
        lcd->lines[i][LCD_MODEL_COLUMNS] = '\0';
    }
    lcd->address = 0;
}

void lcd_model_begin(struct lcd_model *lcd)
{
    memset(lcd, 0, sizeof *lcd);
    clear(lcd);
}

static void show(struct lcd_model *lcd, uint8_t character)
{
    uint8_t line = lcd->address >= SECOND_LINE;
    uint8_t column = (uint8_t)(lcd->address - line * SECOND_LINE);

    if (column < LCD_MODEL_COLUMNS) {
        lcd->lines[line][column] = (char)character;
    }
    lcd->address++;
}

static void obey(struct lcd_model *lcd, uint8_t instruction)
{
    if ((instruction & GO_TO) != 0) {
        lcd->address = (uint8_t)(instruction & ~GO_TO);
    } else if (instruction == CLEAR) {
        clear(lcd);
    }
}

void lcd_model_strobe(struct lcd_model *lcd, bool is_data, uint8_t nibble)
{
    uint8_t byte;

    if (!lcd->is_four_bit) {
        lcd->is_four_bit = !is_data && nibble == FUNCTION_4_BIT;
        return;
    }
    if (!lcd->has_high_half) {
        lcd->high_half = nibble;
        lcd->has_high_half = true;
        return;
    }
    lcd->has_high_half = false;
    byte = (uint8_t)(lcd->high_half << 4 | nibble);
    if (is_data) {
        show(lcd, byte);
    } else {
        obey(lcd, byte);
    }
}
