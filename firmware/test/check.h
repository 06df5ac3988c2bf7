/* The little that the tests need: a check that counts, and says what was found where. */
#ifndef CHECK_H
#define CHECK_H

#include <inttypes.h>
#include <stdio.h>

extern unsigned check_count;
extern unsigned check_failures;

/* Says how many checks failed. Returns the exit code. */
int check_result(void);

#define CHECK(condition)                                                          \
    do {                                                                          \
        check_count++;                                                            \
        if (!(condition)) {                                                       \
            check_failures++;                                                     \
            printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #condition);        \
        }                                                                         \
    } while (0)

#define CHECK_EQUAL(expected, actual)                                             \
    do {                                                                          \
        int64_t check_expected = (int64_t)(expected);                             \
        int64_t check_actual = (int64_t)(actual);                                 \
        check_count++;                                                            \
        if (check_expected != check_actual) {                                     \
            check_failures++;                                                     \
            printf("%s:%d: %s is %" PRId64 ", not %" PRId64 "\n", __FILE__, __LINE__, \
                   #actual, check_actual, check_expected);                        \
        }                                                                         \
    } while (0)

#define CHECK_NEAR(expected, actual, tolerance)                                   \
    do {                                                                          \
        double check_expected = (double)(expected);                               \
        double check_actual = (double)(actual);                                   \
        check_count++;                                                            \
        if (!(check_actual >= check_expected - (tolerance) &&                     \
              check_actual <= check_expected + (tolerance))) {                    \
            check_failures++;                                                     \
            printf("%s:%d: %s is %.6f, not %.6f\n", __FILE__, __LINE__, #actual,  \
                   check_actual, check_expected);                                 \
        }                                                                         \
    } while (0)

#endif
