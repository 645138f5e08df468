/**
 * Planners of ways around obstacles: the interface that extensions implement too, and the house's
 * own. How a way is followed belongs to planning.local.
 */
package org.u2sa.core.planning.route;
