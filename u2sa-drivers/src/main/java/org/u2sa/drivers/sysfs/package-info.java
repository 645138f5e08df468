/**
 * Sensors with Linux kernel drivers, read through sysfs. Sensors with a link of their own are in
 * the package of the quantity that they measure.
 */
package org.u2sa.drivers.sysfs;
