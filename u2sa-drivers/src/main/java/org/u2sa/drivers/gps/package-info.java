/**
 * Satellite receivers: what their bytes mean, and how they are set up. How the bytes come belongs
 * to {@code org.u2sa.drivers.link}, what becomes of a fix to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.gps;
