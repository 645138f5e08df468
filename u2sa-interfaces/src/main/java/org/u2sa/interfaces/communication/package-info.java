/**
 * How services talk (thesis 3.2.1.2–3.2.1.4): channels, topics, and the two ways to the
 * Communication Manager, directly and over MQTT. What is said belongs to the messages, the broker
 * itself to the core module.
 */
package org.u2sa.interfaces.communication;
