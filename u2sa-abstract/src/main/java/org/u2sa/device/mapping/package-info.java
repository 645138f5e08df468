/** Maps readings of devices to states of the vehicle. */
package org.u2sa.device.mapping;
