#include "pose.h"

#include "angle.h"

static int64_t rounded_q15(int64_t value)
{
    return (value + (1 << 14)) >> 15;
}

void pose_rotate(int64_t *x, int64_t *y, uint32_t angle)
{
    int64_t cos = angle_cos_q15(angle);
    int64_t sin = angle_sin_q15(angle);
    int64_t turned_x = rounded_q15(*x * cos - *y * sin);

    *y = rounded_q15(*x * sin + *y * cos);
    *x = turned_x;
}

void pose_advance(struct pose *pose, const struct step *step)
{
    int64_t x = step->x_um_q16;
    int64_t y = step->y_um_q16;

    pose_rotate(&x, &y, pose->heading + (uint32_t)(step->turn / 2));
    pose->x_um_q16 += x;
    pose->y_um_q16 += y;
    pose->heading += (uint32_t)step->turn;
}
