/**
 * Obstacle avoidance on the way to a goal: routes, virtual obstacles, waiting, and looking around.
 */
package org.u2sa.planning.avoidance;
