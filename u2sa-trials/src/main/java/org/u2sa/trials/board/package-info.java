/**
 * {@code u2sa board}: a vehicle file behind a simulated IOIO board, in real time, for a phone or a
 * program on the network. The board itself belongs to {@code org.u2sa.sim.ioio}.
 */
package org.u2sa.trials.board;
