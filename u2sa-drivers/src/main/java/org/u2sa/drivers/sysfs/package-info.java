/**
 * Sensors that Linux's kernel has drivers for, read through the files of its sysfs. Sensors on a
 * link of their own belong to the package of their subject.
 */
package org.u2sa.drivers.sysfs;
