/** RoboSub's layouts, their tasks and judges. Not here: goal classes and planner states. */
package org.u2sa.scenarios.robosub.course;
