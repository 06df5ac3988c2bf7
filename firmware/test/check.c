#include "check.h"

unsigned check_count;
unsigned check_failures;

int check_result(void)
{
    printf("%u checks, %u failures\n", check_count, check_failures);
    return check_failures == 0 && check_count > 0 ? 0 : 1;
}
