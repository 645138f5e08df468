/**
 * The World Modeler (thesis 3.2.3.3): what is known of the vehicle's surroundings, from sensors and
 * from files, as objects and as a grid. How a vehicle gets around them is the planner's matter.
 */
package org.u2sa.world;
