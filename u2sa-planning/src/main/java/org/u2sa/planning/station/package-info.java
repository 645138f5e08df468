/** Stations and berths of vehicles that cannot move sideways: heading, way in, and giving up. */
package org.u2sa.planning.station;
