/**
 * Ways to a device: two-way streams of bytes that may be lost and come back. What the bytes mean
 * belongs to the packages of the devices.
 */
package org.u2sa.drivers.link;
