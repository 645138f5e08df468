/**
 * Lidars and range finders other than sonars. The use of distances and scans belongs to {@code
 * org.u2sa.device}.
 */
package org.u2sa.drivers.range;
