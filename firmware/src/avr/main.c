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

enum { PANEL_PERIOD_MS = 100 };

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

    while (spi_slave_take(&byte)) {
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

static void live(uint32_t now_ms)
{
    sensors_look(&inputs);
    robot_watch(&robot, &inputs, now_ms);
    if (now_ms % DRIVE_PERIOD_MS == 0) {
        robot_drive(&robot);
        offer_status();
    }
    if (now_ms % PANEL_PERIOD_MS == 0) {
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
        hear();
        if (lived_ms != clock_ms()) {
            lived_ms++; /* one after the other, also after a long step */
            live(lived_ms);
            wdt_reset();
        } else {
            sleep_mode(); /* idle; an interrupt that comes just before costs a millisecond */
        }
    }
}
