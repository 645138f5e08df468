/** Guidance: the line to follow to a goal, and the direction and altitude along it. */
package org.u2sa.planning.guidance;
