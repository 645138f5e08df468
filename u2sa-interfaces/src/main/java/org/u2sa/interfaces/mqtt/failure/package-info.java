/**
 * Explains why a client and a broker could not come together. Nothing here connects, except to ask
 * whether a port is encrypted.
 */
package org.u2sa.interfaces.mqtt.failure;
