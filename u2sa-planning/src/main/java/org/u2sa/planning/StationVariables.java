package org.u2sa.planning;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of stations and berths. */
record StationVariables(
    @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 5)
        @Description(
            "Distance from a station at which the vehicle turns to the heading that it is to keep there.")
        double stationTurnWithin,
    @Variable(unit = "deg", min = 0.1, max = 180, ifAbsent = 5)
        @Description("Heading error up to which a vehicle counts as being on a station's heading.")
        double stationAngle,
    @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.3)
        @Description(
            "Distance from the start of the straight way to a berth at which the vehicle enters it, and from the way's line at which it waits until it is back.")
        double berthAccuracy,
    @Variable(unit = "m/s", min = 0.01, max = 10, ifAbsent = 0.3)
        @Description("Speed on the straight way to a berth that specifies none.")
        double berthSpeed,
    @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 1)
        @Description("Look-ahead distance on the straight way to a berth.")
        double berthLookAhead) {}
