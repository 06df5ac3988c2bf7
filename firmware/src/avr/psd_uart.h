/* Bytes of the range sensors' board, by USART1. */
#ifndef PSD_UART_H
#define PSD_UART_H

#include <stdbool.h>
#include <stdint.h>

void psd_uart_begin(void);

/* Returns whether there was a byte. */
bool psd_uart_take_byte(uint8_t *byte);

#endif
