/**
 * Transports to devices: bidirectional byte streams that reconnect. Protocols belong to the device
 * packages.
 */
package org.u2sa.drivers.link;
