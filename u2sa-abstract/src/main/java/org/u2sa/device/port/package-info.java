/**
 * Ports to devices, implemented by drivers, simulators and tests, and the readings that services
 * receive.
 */
package org.u2sa.device.port;
