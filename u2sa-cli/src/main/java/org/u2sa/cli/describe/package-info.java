/**
 * {@code u2sa describe}: shows a vehicle's composition and autonomy. The levels are defined by
 * {@code AutonomyLevels} in core.
 */
package org.u2sa.cli.describe;
