/**
 * The command line {@code u2sa}: its frame, its options and the interface through which other
 * modules add commands. Commands that start systems or demos do not belong here, nor does anything
 * specific to a simulator or vehicle.
 */
package org.u2sa.cli;
