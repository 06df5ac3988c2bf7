#include "panel.h"

#include <string.h>

static void write_line(char *line, const char *first, const char *second)
{
    size_t first_length = strlen(first);

    memset(line, ' ', PANEL_COLUMNS);
    memcpy(line, first, first_length);
    memcpy(line + first_length, second, strlen(second));
}

void panel_write(struct panel *panel, const struct robot *robot)
{
    memcpy(panel->lines[0], robot->caption, PANEL_COLUMNS);
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
