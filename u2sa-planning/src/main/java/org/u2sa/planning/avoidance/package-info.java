/** Obstacle avoidance on the way to a goal: passages, guesses, waiting, and looking around. */
package org.u2sa.planning.avoidance;
