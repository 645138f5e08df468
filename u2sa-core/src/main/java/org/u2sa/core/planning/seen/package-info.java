/**
 * What the World Modeler says of the surroundings, as planners use it: shapes and traffic in metres
 * on one plane, and a grid of costs. Where to go is not decided here.
 */
package org.u2sa.core.planning.seen;
