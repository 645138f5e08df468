/**
 * Planners of paths around obstacles: the interface, also for extensions, and the built-in
 * planners. Path following belongs to planning.local.
 */
package org.u2sa.planning.route;
