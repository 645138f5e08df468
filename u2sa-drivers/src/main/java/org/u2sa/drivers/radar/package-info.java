/** Radars that track targets. Receivers of others' reports belong to {@code drivers.traffic}. */
package org.u2sa.drivers.radar;
