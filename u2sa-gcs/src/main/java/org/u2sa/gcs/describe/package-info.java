/**
 * {@code u2sa describe}: what a vehicle is made of, and how autonomous it is. What the levels mean
 * is {@code AutonomyLevels}' concern in core.
 */
package org.u2sa.gcs.describe;
