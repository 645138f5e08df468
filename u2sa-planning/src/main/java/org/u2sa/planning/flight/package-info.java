/**
 * What an aircraft's planner needs besides its goals: variables of flight, the place where it
 * hovers, and the last checks of each step.
 */
package org.u2sa.planning.flight;
