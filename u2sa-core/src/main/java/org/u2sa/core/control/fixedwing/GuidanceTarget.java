package org.u2sa.core.control.fixedwing;

import java.util.OptionalDouble;

/**
 * Where navigation wants the aircraft.
 *
 * @param northM of a point ahead on the leg, from the aircraft [m]
 * @param eastM of that point, from the aircraft [m]
 * @param altitudeM to hold, above mean sea level [m]
 * @param speedMps true airspeed asked for [m/s]; empty leaves the cruise speed
 */
record GuidanceTarget(double northM, double eastM, double altitudeM, OptionalDouble speedMps) {}
