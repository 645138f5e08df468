/**
 * Following a route within the vehicle's motion limits, past traffic. Route planning belongs to
 * planning.route.
 */
package org.u2sa.planning.local;
