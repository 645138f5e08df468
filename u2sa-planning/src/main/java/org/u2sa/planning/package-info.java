/**
 * The Path Planner (thesis 3.2.3.4): a state machine over the classes of goals, and the geometry of
 * reaching waypoints. The choice of the next goal belongs to mission, actuation to control.
 */
package org.u2sa.planning;
