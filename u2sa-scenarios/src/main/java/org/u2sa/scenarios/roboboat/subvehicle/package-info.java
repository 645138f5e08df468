/**
 * Goal class and planner state of RoboBoat's quadrotor sub-vehicle, which fetches a puck from a
 * dock (thesis 4.2.1.3). The boat's own tasks do not belong here.
 */
package org.u2sa.scenarios.roboboat.subvehicle;
