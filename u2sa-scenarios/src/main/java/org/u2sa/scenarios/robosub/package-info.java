/** RoboSub (thesis 4.3): layout, judge, goal classes and planner states. Not here: services. */
package org.u2sa.scenarios.robosub;
