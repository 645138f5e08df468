package org.u2sa.drivers.ioio;

/**
 * Where a serial device is wired.
 *
 * @param receive pin at which its bytes come
 * @param transmit pin at which bytes to it leave, −1 if none
 * @param baud rate [bit/s]; 8 bits, no parity, one stop bit
 */
record UartPins(int receive, int transmit, int baud) {}
