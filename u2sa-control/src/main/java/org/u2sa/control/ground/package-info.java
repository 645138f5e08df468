/**
 * Control systems of ground vehicles (thesis 4.6.2.5): navigation points in, percentages for the
 * motors of a differential or an Ackermann vehicle out. Pin assignment and pulse widths of motors
 * belong to the drivers.
 */
package org.u2sa.control.ground;
