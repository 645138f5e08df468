/**
 * What the vehicle does when something is wrong, and whether it may move at all: failsafe matrix,
 * geofence, checks before arming. Who is alive is found out by health, and how a goal is reached by
 * planning.
 */
package org.u2sa.core.safety;
