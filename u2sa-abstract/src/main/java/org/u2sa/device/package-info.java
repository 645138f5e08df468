/**
 * Services for devices: each needs only a port of {@code port}, and opens the device that its
 * configuration names. Protocols of real devices are in {@code org.u2sa.drivers}, simulated devices
 * in {@code org.u2sa.sim}.
 */
package org.u2sa.device;
