#include "panel.h"

#include <string.h>

static char digit(unsigned number)
{
    return (char)('0' + number % 10);
}

static void write_line(char *line, const char *first, const char *second)
{
    size_t first_length = strlen(first);

    memset(line, ' ', PANEL_COLUMNS);
    memcpy(line, first, first_length);
    memcpy(line + first_length, second, strlen(second));
}

/* Such as "15.93 V  25 C". */
static void write_measurements(char *line, const struct robot *robot)
{
    uint16_t centivolts = battery_mv(&robot->battery) / 10;
    uint8_t degrees = robot->temperature < 0 ? 0 : (uint8_t)robot->temperature;
    char text[] = "00.00 V  000 C";

    text[0] = digit(centivolts / 1000);
    text[1] = digit(centivolts / 100);
    text[3] = digit(centivolts / 10);
    text[4] = digit(centivolts);
    text[9] = digit(degrees / 100);
    text[10] = digit(degrees / 10);
    text[11] = digit(degrees);
    write_line(line, text, "");
}

void panel_write(struct panel *panel, const struct robot *robot)
{
    memcpy(panel->lines[0], robot->caption, PANEL_COLUMNS);
    if (robot->shows_measurements && robot->stop.reasons == 0) {
        write_measurements(panel->lines[1], robot);
        return;
    }
    switch (robot_state(robot)) {
    case ROBOT_STOPPED:
        write_line(panel->lines[1], "STOPPED: ", stop_text(robot->stop.reasons));
        break;
    case ROBOT_STANDING:
    case ROBOT_PATH_STANDING:
        write_line(panel->lines[1], "READY", "");
        break;
    case ROBOT_DRIVING:
    case ROBOT_PATH_DRIVING:
        write_line(panel->lines[1], "DRIVING", "");
        break;
    }
}
