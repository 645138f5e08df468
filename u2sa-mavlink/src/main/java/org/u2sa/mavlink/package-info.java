/**
 * MAVLink framing and dialect, for drivers and bridges. What the messages mean to a vehicle belongs
 * to those who send and receive them.
 */
package org.u2sa.mavlink;
