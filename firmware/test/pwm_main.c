#include "check.h"
#include "tests.h"

int main(void)
{
    pwm_drive_tests();
    robot_tests();
    return check_result();
}
