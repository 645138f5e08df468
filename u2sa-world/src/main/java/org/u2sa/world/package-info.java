/**
 * The World Modeler (thesis 3.2.3.3): a model of the vehicle's surroundings from sensors and files,
 * as objects and as a grid. Finding a way around obstacles belongs to the planner.
 */
package org.u2sa.world;
