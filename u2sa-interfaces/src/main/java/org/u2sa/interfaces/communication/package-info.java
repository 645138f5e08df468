/**
 * Communication of services (thesis 3.2.1.2–3.2.1.4): channels, topics, and the two transports,
 * in-process and MQTT. Message content belongs to the messages module, the broker to core.
 */
package org.u2sa.interfaces.communication;
