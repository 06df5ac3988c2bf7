/* The main loop: connects the robot's logic to the peripherals. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "arm_bus.h"
#include "clock.h"
#include "drive.h"
#include "lcd.h"
#include "panel.h"
#include "power_cycle.h"
#include "psd_uart.h"
#include "robot.h"
#include "sensors.h"
#include "settings_store.h"
#include "spi_slave.h"

enum {
    PANEL_PERIOD_MS = 100,
    STORE_PERIOD_MS = 16, /* the EEPROM takes 8.5 ms for a byte */
    MAX_BYTES = 32, /* to be received at once: half a frame; a millisecond brings 62 at most */
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

    robot_fill_status(&robot, &status);
    status.bad_frames = parser.bad;
    status.lost_bytes = spi_slave_lost_bytes();
    if (robot.conversation.is_of_arm) {
        struct arm_report arm = arm_report_of(&robot.arm);

        status_write_arm(&status, &arm, frame);
    } else {
        status_write(&status, frame);
    }
}

static void publish_status(void)
{
    write_status(spi_slave_draft());
    spi_slave_offer();
}

static void receive(void)
{
    uint8_t byte;

    for (uint8_t i = 0; i < MAX_BYTES; i++) {
        if (spi_slave_take_pause()) {
            frame_parser_pause(&parser);
        }
        if (!spi_slave_take_byte(&byte)) {
            break;
        }
        if (frame_parser_add(&parser, byte)) {
            robot_handle_frame(&robot, parser.bytes);
            publish_status();
        }
    }
    while (psd_uart_take_byte(&byte)) {
        range_take_byte(&robot.range, byte);
    }
}

/* Once a millisecond: returns whether a period is over. */
static bool advance_period(uint8_t *passed_ms, uint8_t period_ms)
{
    (*passed_ms)++;
    if (*passed_ms < period_ms) {
        return false;
    }
    *passed_ms = 0;
    return true;
}

static void run_millisecond(uint32_t now_ms)
{
    static uint8_t since_drive_ms;
    static uint8_t since_panel_ms;

    sensors_sample(&inputs);
    arm_bus_step(&robot.arm);
    robot_update(&robot, &inputs, now_ms);
    if (advance_period(&since_drive_ms, DRIVE_PERIOD_MS)) {
        robot_control_wheels(&robot);
    } else if (since_drive_ms == 1) {
        publish_status(); /* not in the same millisecond, which is long enough */
    }
    if (advance_period(&since_panel_ms, PANEL_PERIOD_MS)) {
        panel_write(&panel, &robot);
    }
    lcd_step(&panel);
    if ((uint8_t)now_ms % STORE_PERIOD_MS == 0) {
        settings_store_step(&robot.settings, &robot.arm.settings);
    }
}

static void begin(void)
{
    uint8_t first[FRAME_LENGTH];
    enum stop_reason reason = reason_of_start();
    struct settings settings;
    struct arm_settings arm_settings;

    settings_store_read(&settings, &arm_settings);
    wdt_enable(WDTO_250MS);
    wdt_reset();
    lcd_begin();
    sensors_begin(&inputs);
    arm_bus_begin();
    psd_uart_begin();
    frame_parser_begin(&parser);
    robot_begin(&robot, reason, power_cycle_count(), &settings, &arm_settings);
    panel_write(&panel, &robot);
    write_status(first);
    spi_slave_begin(first);
    clock_begin();
    sei();
}

int main(void)
{
    uint32_t run_ms = 0;

    begin();
    for (;;) {
        if ((uint8_t)run_ms != clock_ticks()) {
            run_ms++; /* one after the other, also after a long step */
            receive();
            run_millisecond(run_ms);
            wdt_reset();
        } else {
            sleep_mode(); /* idle; an interrupt that comes just before costs a millisecond */
        }
    }
}
