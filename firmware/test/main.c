#include "check.h"
#include "tests.h"

unsigned check_count;
unsigned check_failures;

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: %s GOLDEN-FRAMES\n", arguments[0]);
        return 2;
    }
    frame_tests();
    golden_tests(arguments[1]);
    kinematics_tests();
    part_tests();
    robot_tests();
    printf("%u checks, %u failures\n", check_count, check_failures);
    return check_failures == 0 && check_count > 0 ? 0 : 1;
}
