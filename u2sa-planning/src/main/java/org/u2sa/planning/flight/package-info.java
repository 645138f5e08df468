/**
 * Planner states of aircraft: take-off, landing, loitering and dropping a payload. Waypoints, and
 * whatever other vehicles do too, belong to {@code org.u2sa.planning}.
 */
package org.u2sa.planning.flight;
