/**
 * Shows how late a receiver's fixes are, from its velocities and an inertial path. Plain arrays, so
 * that the filter saves and restores them with its state; nothing of the filter belongs here.
 */
package org.u2sa.estimation.delay;
