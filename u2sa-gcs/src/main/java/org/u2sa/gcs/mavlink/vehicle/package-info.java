/**
 * The vehicle as the MAVLink bridge knows it: its latest messages, and orders to it with their
 * answers. Nothing here knows a packet.
 */
package org.u2sa.gcs.mavlink.vehicle;
