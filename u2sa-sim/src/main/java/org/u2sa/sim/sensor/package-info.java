/**
 * What sensors make of the truth: errors, delays and drop-outs from one random stream a sensor, and
 * the bytes that real devices would send. Which vehicle carries them belongs to the packages of the
 * vehicles; reading the bytes belongs to the drivers.
 */
package org.u2sa.sim.sensor;
