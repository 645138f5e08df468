/**
 * The command line {@code u2sa}: its frame, its options and the interface through which other
 * modules add commands. Commands that start systems or demos do not belong here, nor anything that
 * knows a particular simulator or vehicle.
 */
package org.u2sa.gcs;
