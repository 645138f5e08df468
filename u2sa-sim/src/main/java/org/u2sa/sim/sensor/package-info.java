/**
 * Sensor models: errors, delays and outages from one random stream per sensor, and the bytes real
 * devices would send. Mounting belongs to the vehicle packages; parsing the bytes belongs to the
 * drivers.
 */
package org.u2sa.sim.sensor;
