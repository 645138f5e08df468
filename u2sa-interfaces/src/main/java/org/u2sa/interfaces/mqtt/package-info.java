/** MQTT transport: two clients, ours and Eclipse Paho, behind one connection. */
package org.u2sa.interfaces.mqtt;
