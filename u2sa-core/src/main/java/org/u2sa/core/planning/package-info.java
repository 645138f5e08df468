/**
 * The Path Planner (thesis 3.2.3.4): a state machine over the classes of goals, and the geometry of
 * reaching waypoints. Which goal comes next belongs to mission, how actuators move to control.
 */
package org.u2sa.core.planning;
