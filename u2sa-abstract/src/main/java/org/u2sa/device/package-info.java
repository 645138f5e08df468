/**
 * Device ports: a small interface and a reading type for each kind of device, and the services that
 * need only the port. Protocols of real devices are in {@code org.u2sa.drivers}, simulated devices
 * in {@code org.u2sa.sim}.
 */
package org.u2sa.device;
