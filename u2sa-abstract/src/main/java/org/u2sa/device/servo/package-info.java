/**
 * The actuator service of one servo: control surfaces, rudders, gimbals. Servo controllers are in
 * {@code org.u2sa.drivers.motor}, simulated servos in {@code org.u2sa.sim.device}.
 */
package org.u2sa.device.servo;
