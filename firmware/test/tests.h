#ifndef TESTS_H
#define TESTS_H

void arm_tests(void);
void frame_tests(void);
void golden_tests(const char *file);
void kinematics_tests(void);
void lm629_tests(void);
void part_tests(void);
void pwm_drive_tests(void);
void robot_tests(void);

#endif
