#include "lcd.h"

#include <util/delay.h>

#include "board.h"

enum {
    FUNCTION_4_BIT_2_LINES = 0x28,
    DISPLAY_ON = 0x0C,
    ENTRY_RIGHTWARDS = 0x06,
    CLEAR = 0x01,
    GO_TO = 0x80,
    SECOND_LINE = 0x40,

    STEPS_A_LINE = PANEL_COLUMNS + 1, /* the cursor, then the characters */
};

static uint8_t step;

static void put_half(uint8_t high_nibble)
{
    LCD_PORT = (uint8_t)((LCD_PORT & ~LCD_DATA) | (high_nibble & LCD_DATA));
    LCD_CONTROL_PORT |= LCD_E;
    _delay_us(0.5);
    LCD_CONTROL_PORT &= (uint8_t)~LCD_E;
    _delay_us(0.5);
}

/* The display needs 37 us after it; the next one comes a millisecond later. */
static void put(uint8_t byte)
{
    put_half(byte);
    put_half((uint8_t)(byte << 4));
}

static void put_instruction(uint8_t instruction)
{
    LCD_CONTROL_PORT &= (uint8_t)~LCD_RS;
    put(instruction);
}

void lcd_begin(void)
{
    LCD_DDR |= LCD_DATA;
    LCD_CONTROL_DDR |= LCD_RS | LCD_E;
    LCD_CONTROL_PORT &= (uint8_t) ~(LCD_RS | LCD_E);
    _delay_ms(40);
    for (uint8_t i = 0; i < 3; i++) { /* whatever mode it was in: 8 bits */
        put_half(0x30);
        _delay_ms(5);
    }
    put_half(0x20);
    _delay_us(50);
    put_instruction(FUNCTION_4_BIT_2_LINES);
    _delay_us(50);
    put_instruction(DISPLAY_ON);
    _delay_us(50);
    put_instruction(ENTRY_RIGHTWARDS);
    _delay_us(50);
    put_instruction(CLEAR);
    _delay_ms(2);
}

void lcd_step(const struct panel *panel)
{
    uint8_t line = step / STEPS_A_LINE;
    uint8_t in_line = step % STEPS_A_LINE;

    if (in_line == 0) {
        put_instruction((uint8_t)(GO_TO | (line == 0 ? 0 : SECOND_LINE)));
    } else {
        LCD_CONTROL_PORT |= LCD_RS;
        put((uint8_t)panel->lines[line][in_line - 1]);
    }
    step = (uint8_t)(step + 1U == PANEL_LINES * STEPS_A_LINE ? 0 : step + 1U);
}
