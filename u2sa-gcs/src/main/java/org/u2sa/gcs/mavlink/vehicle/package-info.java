/**
 * The vehicle as the MAVLink bridge knows it: its latest messages, and orders to it with their
 * answers. Packets are handled elsewhere.
 */
package org.u2sa.gcs.mavlink.vehicle;
