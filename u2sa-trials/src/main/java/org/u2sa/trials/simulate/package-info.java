/**
 * {@code u2sa simulate} and {@code u2sa vehicle}: any system file with the vehicle of a file. The
 * vehicle itself belongs to {@code org.u2sa.sim.file}.
 */
package org.u2sa.trials.simulate;
