/**
 * Compasses: what their bytes mean, where magnetic north lies, and the service that publishes the
 * heading. How the bytes come belongs to {@code org.u2sa.drivers.link}.
 */
package org.u2sa.drivers.compass;
