package org.u2sa.planning.station;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of stations and berths. */
public record StationVariables(
    @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 5)
        @Description("Distance from a station at which the vehicle turns to its required heading.")
        double stationTurnWithin,
    @Variable(unit = "deg", min = 0.1, max = 180, ifAbsent = 5)
        @Description("Heading error up to which a vehicle counts as being on a station's heading.")
        double stationAngle,
    @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.3)
        @Description(
            "Tolerance at the start of the straight way to a berth, and cross-track error at which the vehicle waits until it is back on the way's line.")
        double berthAccuracy,
    @Variable(unit = "m/s", min = 0.01, max = 10, ifAbsent = 0.3)
        @Description("Speed on the straight way to a berth that does not specify one.")
        double berthSpeed,
    @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 1)
        @Description("Look-ahead distance on the straight way to a berth.")
        double berthLookAhead,
    @Variable(unit = "s", min = 0, max = 100000, ifAbsent = 300)
        @Description(
            "Time near a station, in addition to its duration and its straight way, after which it is given up if it has not been kept for its duration; likewise on a detour from a circle without coming farther along it; 0: never.")
        double stationGiveUpAfter) {}
