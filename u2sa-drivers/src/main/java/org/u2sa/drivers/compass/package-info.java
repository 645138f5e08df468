/**
 * Compasses: what their bytes mean. How the bytes come belongs to {@code org.u2sa.drivers.link},
 * what becomes of a heading to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.compass;
