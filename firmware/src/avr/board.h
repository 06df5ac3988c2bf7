/*
 * Every pin of the robot's board. The ED-7275's own wiring is not published: this is the wiring
 * that the firmware expects, and a robot wired otherwise needs this file changed and no other.
 *
 *   PA0-7  LM629 data bus                    (PWM drive: PA0-2 direction, PA4-6 encoder B)
 *   PB0-3  SPI slave: SS SCK MOSI MISO       PB5-7  PWM drive: OC1A OC1B OC1C
 *   PC0    LM629 PS    PC1 RD    PC2 WR    PC3-5 CS of wheels 1 to 3    PC6 RST, all active low
 *   PD2    USART1 RXD: range sensors, 38400 baud
 *   PD4-7  display D4-D7                     PG0 RS   PG1 E
 *   PD0    motor drivers too hot, active low PD1  stop switch, active low
 *   PD3    switch 3, PE2  switch 2, PE7  switch 4, active low
 *   PE3    OC3A: pulses of the arm's servos  PG2-3  which of them: 74HC4052, that of the shoulder,
 *          of the elbow, of the hand, none; its other half leads to PF7 the potentiometers of
 *          shoulder and elbow, nothing, and the load sensor
 *   PE4-6  PWM drive: encoder A (INT4-6)
 *   PF0    battery, 1:5                      PF1-5  floor sensors
 *   PF6    temperature of the motor drivers, 10 mV a degree Celsius (as of an LM35)
 */
#ifndef BOARD_H
#define BOARD_H

#include <avr/io.h>

#define LM629_DATA_PORT PORTA
#define LM629_DATA_PIN PINA
#define LM629_DATA_DDR DDRA
#define LM629_CONTROL_PORT PORTC
#define LM629_CONTROL_DDR DDRC
#define LM629_PS _BV(PC0)
#define LM629_RD _BV(PC1)
#define LM629_WR _BV(PC2)
#define LM629_CS(axis) ((uint8_t)(_BV(PC3) << (axis)))
#define LM629_RST _BV(PC6)
#define LM629_CONTROL_PINS 0x7F

#define SPI_PORT PORTB
#define SPI_DDR DDRB
#define SPI_MISO _BV(PB3)

#define LCD_PORT PORTD
#define LCD_DDR DDRD
#define LCD_DATA 0xF0
#define LCD_CONTROL_PORT PORTG
#define LCD_CONTROL_DDR DDRG
#define LCD_RS _BV(PG0)
#define LCD_E _BV(PG1)

#define ALARM_PORT PORTD
#define ALARM_PIN PIND
#define ALARM_HEAT _BV(PD0)
#define ALARM_SWITCH _BV(PD1)

#define SWITCH_PORT PORTE
#define SWITCH_PIN PINE
#define SWITCH_2 _BV(PE2)
#define SWITCH_4 _BV(PE7)
#define SWITCH_3_PORT PORTD
#define SWITCH_3_PIN PIND
#define SWITCH_3 _BV(PD3)

#define ARM_PULSE_DDR DDRE
#define ARM_PULSE _BV(PE3)
#define ARM_SELECT_PORT PORTG
#define ARM_SELECT_DDR DDRG
#define ARM_SELECT_0 PG2
#define ARM_SELECT (_BV(PG2) | _BV(PG3))

#define BATTERY_CHANNEL 0
#define BATTERY_DIVIDER 5
#define FLOOR_CHANNEL 1
#define TEMPERATURE_CHANNEL 6
#define ARM_ADC_CHANNEL 7
#define MV_A_DEGREE 10

#define ADC_REFERENCE_MV 5000

#define PWM_DDR DDRB
#define PWM_PINS (_BV(PB5) | _BV(PB6) | _BV(PB7))
#define DIRECTION_PORT PORTA
#define DIRECTION_DDR DDRA
#define DIRECTION(wheel) ((uint8_t)(_BV(PA0) << (wheel)))
#define ENCODER_A_PORT PORTE
#define ENCODER_A_PIN PINE
#define ENCODER_A(wheel) ((uint8_t)(_BV(PE4) << (wheel)))
#define ENCODER_B_PORT PORTA
#define ENCODER_B_PIN PINA
#define ENCODER_B(wheel) ((uint8_t)(_BV(PA4) << (wheel)))

#endif
