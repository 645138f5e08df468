package org.u2sa.control.fixedwing;

import java.util.OptionalDouble;

/**
 * Target of the aircraft from navigation.
 *
 * @param northM north of a point ahead on the leg, from the aircraft [m]
 * @param eastM east of that point, from the aircraft [m]
 * @param altitudeM altitude to hold, above mean sea level [m]
 * @param speedMps demanded true airspeed [m/s]; empty for the cruise speed
 */
record GuidanceTarget(double northM, double eastM, double altitudeM, OptionalDouble speedMps) {}
