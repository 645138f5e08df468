/** Rotations as unit quaternions, on plain arrays. */
package org.u2sa.estimation.rotation;
