/**
 * Ports to devices: what a driver, a simulator or a test implements, and the readings that services
 * get.
 */
package org.u2sa.device.port;
