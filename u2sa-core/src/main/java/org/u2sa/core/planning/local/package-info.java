/**
 * Following a route within what the vehicle's motion allows, past what moves. What the route is
 * belongs to planning.route.
 */
package org.u2sa.core.planning.local;
