/**
 * Satellite receivers: what their bytes mean, how they are set up, and the service that publishes
 * what they measured. How the bytes come belongs to {@code org.u2sa.drivers.link}.
 */
package org.u2sa.drivers.gps;
