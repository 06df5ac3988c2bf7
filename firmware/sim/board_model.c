#include "board_model.h"

#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_time.h>
#include <string.h>

/* Data space address of the ATmega128's register. */
enum { PORTD_ADDRESS = 0x32 };

enum {
    LCD_RS = 1 << 0,
    LCD_E = 1 << 1,

    HEAT_PIN = 0,
    SWITCH_PIN = 1,

    BATTERY_DIVIDER = 5,
    TEMPERATURE_CHANNEL = 6,
    MV_A_DEGREE = 10,
    NO_FLOOR_MV = 200,

    RANGE_PERIOD_US = 50000,
    RANGE_BYTE_US = 300, /* 38400 baud: 260 us */
};

/* Of switches 2 to 4. */
static const struct {
    char port;
    int number;
} SWITCH_PINS[CHIP_SWITCHES] = {{'E', 2}, {'D', 3}, {'E', 7}};

static avr_irq_t *port(struct board_model *board, char name, int irq)
{
    return avr_io_getirq(board->avr, (uint32_t)AVR_IOCTL_IOPORT_GETIRQ(name), irq);
}

static void on_lcd_lines(avr_irq_t *irq, uint32_t value, void *parameter)
{
    struct board_model *board = parameter;
    uint8_t fallen = (uint8_t)(board->lcd_lines & ~value);

    (void)irq;
    board->lcd_lines = (uint8_t)value;
    if ((fallen & LCD_E) != 0) {
        lcd_model_strobe(board->lcd, (value & LCD_RS) != 0, board->avr->data[PORTD_ADDRESS] >> 4);
    }
}

/* 0xFF, three times two bytes of 7 bits, and their sum modulo 128. */
static void write_range_message(struct board_model *board)
{
    uint8_t *message = board->range_message;
    unsigned sum = 0;

    message[0] = 0xFF;
    for (int i = 0; i < CHIP_RANGES; i++) {
        message[1 + 2 * i] = (uint8_t)(board->surroundings->range_mm[i] >> 7 & 0x7F);
        message[2 + 2 * i] = (uint8_t)(board->surroundings->range_mm[i] & 0x7F);
        sum += message[1 + 2 * i];
        sum += message[2 + 2 * i];
    }
    message[7] = (uint8_t)(sum & 0x7F);
}

static avr_cycle_count_t send_range(avr_t *avr, avr_cycle_count_t when, void *parameter)
{
    struct board_model *board = parameter;
    avr_irq_t *uart = avr_io_getirq(avr, (uint32_t)AVR_IOCTL_UART_GETIRQ('1'), UART_IRQ_INPUT);

    if (board->range_sent == 0) {
        write_range_message(board);
    }
    if (!board->surroundings->is_range_board_silent) {
        avr_raise_irq(uart, board->range_message[board->range_sent]);
    }
    board->range_sent = (uint8_t)((board->range_sent + 1U) % sizeof board->range_message);
    return when + avr_usec_to_cycles(avr, board->range_sent == 0 ? RANGE_PERIOD_US : RANGE_BYTE_US);
}

static void silence_uart(struct board_model *board)
{
    uint32_t flags = 0;

    avr_ioctl(board->avr, (uint32_t)AVR_IOCTL_UART_SET_FLAGS('1'), &flags);
}

void board_model_wire(struct board_model *board)
{
    avr_irq_register_notify(port(board, 'G', IOPORT_IRQ_REG_PORT), on_lcd_lines, board);
    silence_uart(board);
    board_model_restart(board);
}

void board_model_restart(struct board_model *board)
{
    /* simavr passes on what changes, and the chip has just forgotten its pins */
    avr_raise_irq(port(board, 'D', IOPORT_IRQ_PIN0 + HEAT_PIN), 0);
    avr_raise_irq(port(board, 'D', IOPORT_IRQ_PIN0 + SWITCH_PIN), 0);
    for (int i = 0; i < CHIP_SWITCHES; i++) {
        avr_raise_irq(
            port(board, SWITCH_PINS[i].port, IOPORT_IRQ_PIN0 + SWITCH_PINS[i].number), 0);
    }
    board_model_update(board);
    avr_cycle_timer_register_usec(board->avr, RANGE_PERIOD_US, send_range, board);
}

static void measure(struct board_model *board, int channel, uint32_t mv)
{
    avr_raise_irq(avr_io_getirq(board->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + channel), mv);
}

void board_model_update(struct board_model *board)
{
    const struct surroundings *felt = board->surroundings;

    measure(board, 0, felt->battery_mv / BATTERY_DIVIDER);
    for (int i = 0; i < CHIP_FLOOR_SENSORS; i++) {
        measure(board, 1 + i, felt->is_floor_gone[i] ? NO_FLOOR_MV : felt->floor_mv[i]);
    }
    measure(board, TEMPERATURE_CHANNEL, (uint32_t)felt->temperature * MV_A_DEGREE);
    for (int i = 0; i < CHIP_SWITCHES; i++) {
        avr_raise_irq(port(board, SWITCH_PINS[i].port, IOPORT_IRQ_PIN0 + SWITCH_PINS[i].number),
                      !felt->is_switch_pressed[i]);
    }
    avr_raise_irq(port(board, 'D', IOPORT_IRQ_PIN0 + HEAT_PIN), !felt->is_hot);
    avr_raise_irq(port(board, 'D', IOPORT_IRQ_PIN0 + SWITCH_PIN), !felt->is_stop_pressed);
}
