#include "check.h"
#include "tests.h"

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: %s GOLDEN-FRAMES\n", arguments[0]);
        return 2;
    }
    arm_tests();
    frame_tests();
    golden_tests(arguments[1]);
    kinematics_tests();
    part_tests();
    robot_tests();
    lm629_tests();
    return check_result();
}
