/**
 * Communication of services (thesis 3.2.1.2–3.2.1.4): channels, topics, and the in-process
 * transport; the MQTT transport is in {@code mqtt}. Message content belongs to the messages module,
 * the broker to core.
 */
package org.u2sa.interfaces.communication;
