/**
 * MAVLink framing and dialect, for drivers and bridges. The meaning of messages to a vehicle
 * belongs to their senders and receivers.
 */
package org.u2sa.mavlink;
