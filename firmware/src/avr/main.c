/* Brings the robot's parts to the microcontroller's. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "clock.h"
#include "drive.h"
#include "lcd.h"
#include "panel.h"
#include "power_cycle.h"
#include "psd_uart.h"
#include "robot.h"
#include "sensors.h"
#include "spi_slave.h"

enum {
    PANEL_PERIOD_MS = 100,
    MOST_BYTES = 32, /* to be heard at once: half a frame; a millisecond brings 62 at most */
};

static struct robot robot;
static struct robot_inputs inputs;
static struct frame_parser parser;
static struct panel panel;

/* To be called before the watchdog is set up: the flag that it resets may hold its time short. */
static enum stop_reason reason_of_start(void)
{
    bool was_hung = (MCUCSR & _BV(WDRF)) != 0;

    MCUCSR = 0;
    return was_hung ? STOP_WATCHDOG : STOP_POWER_UP;
}

static void write_status(uint8_t frame[FRAME_LENGTH])
{
    struct status status;

    robot_tell(&robot, &status);
    status.bad_frames = parser.bad;
    status.lost_bytes = spi_slave_lost();
    status_write(&status, frame);
}

static void offer_status(void)
{
    write_status(spi_slave_draft());
    spi_slave_offer();
}

static void hear(void)
{
    uint8_t byte;

    for (uint8_t i = 0; i < MOST_BYTES && spi_slave_take(&byte); i++) {
        if (frame_parser_take(&parser, byte)) {
            robot_hear(&robot, parser.bytes);
            offer_status();
        }
    }
    if (spi_slave_paused()) {
        frame_parser_pause(&parser);
    }
    while (psd_uart_take(&byte)) {
        range_take(&robot.range, byte);
    }
}

/* Once a millisecond: returns whether a period is over. */
static bool is_over(uint8_t *passed_ms, uint8_t period_ms)
{
    (*passed_ms)++;
    if (*passed_ms < period_ms) {
        return false;
    }
    *passed_ms = 0;
    return true;
}

static void live(uint32_t now_ms)
{
    static uint8_t since_drive_ms;
    static uint8_t since_panel_ms;

    sensors_look(&inputs);
    robot_watch(&robot, &inputs, now_ms);
    if (is_over(&since_drive_ms, DRIVE_PERIOD_MS)) {
        robot_drive(&robot);
    } else if (since_drive_ms == 1) {
        offer_status(); /* not in the same millisecond, which is long enough */
    }
    if (is_over(&since_panel_ms, PANEL_PERIOD_MS)) {
        panel_write(&panel, &robot);
    }
    lcd_step(&panel);
}

static void begin(void)
{
    uint8_t first[FRAME_LENGTH];
    enum stop_reason reason = reason_of_start();

    wdt_enable(WDTO_250MS);
    wdt_reset();
    lcd_begin();
    sensors_begin(&inputs);
    psd_uart_begin();
    frame_parser_begin(&parser);
    robot_begin(&robot, reason, power_cycle_count());
    panel_write(&panel, &robot);
    write_status(first);
    spi_slave_begin(first);
    clock_begin();
    sei();
}

int main(void)
{
    uint32_t lived_ms = 0;

    begin();
    for (;;) {
        if ((uint8_t)lived_ms != clock_ticks()) {
            lived_ms++; /* one after the other, also after a long step */
            hear();
            live(lived_ms);
            wdt_reset();
        } else {
            sleep_mode(); /* idle; an interrupt that comes just before costs a millisecond */
        }
    }
}
