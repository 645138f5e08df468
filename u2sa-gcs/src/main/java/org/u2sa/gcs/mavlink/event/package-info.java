/** The MAVLink events interface: what happens to the vehicle, in order, without gaps. */
package org.u2sa.gcs.mavlink.event;
