/**
 * Compass protocols. Transport belongs to {@code org.u2sa.drivers.link}, the use of headings to
 * {@code org.u2sa.device}.
 */
package org.u2sa.drivers.compass;
