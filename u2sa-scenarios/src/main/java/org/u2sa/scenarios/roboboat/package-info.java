/** RoboBoat (thesis 4.2): course generator, goal classes with their planner states, judge, demo. */
package org.u2sa.scenarios.roboboat;
