/**
 * Sensors with Linux kernel drivers, read through sysfs. Sensors on their own link belong to the
 * package of their subject.
 */
package org.u2sa.drivers.sysfs;
