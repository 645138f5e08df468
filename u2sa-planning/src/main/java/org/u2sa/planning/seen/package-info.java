/**
 * The world model as used by planners: shapes and traffic in metres on one plane, and a cost grid.
 * Goals are not decided here.
 */
package org.u2sa.planning.seen;
