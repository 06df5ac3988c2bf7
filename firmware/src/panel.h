/* What the display shows: the caption (the robot's name and address), and state and error. */
#ifndef PANEL_H
#define PANEL_H

#include "robot.h"

enum { PANEL_LINES = 2, PANEL_COLUMNS = CAPTION_LENGTH };

struct panel {
    char lines[PANEL_LINES][PANEL_COLUMNS];
};

void panel_write(struct panel *panel, const struct robot *robot);

#endif
