/**
 * Servo pulses and serial motor controllers with encoders. Command arbitration belongs to {@code
 * org.u2sa.service}.
 */
package org.u2sa.drivers.motor;
