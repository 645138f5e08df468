package org.u2sa.vision.lane;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Settings of the {@link LineModeller}. */
record LineModelVariables(
    @Variable(ifAbsentText = "white line")
        @Description("LINES: types of objects that are painted lines, separated by commas.")
        String lineTypes,
    @Variable(unit = "m", min = 0.01, max = 5, ifAbsent = 0.35)
        @Description(
            "LINES: lateral distance up to which a sighting is associated with a known line.")
        double lineGate,
    @Variable(min = 1, max = 20, ifAbsent = 3) @Description("LINES: sightings that confirm a line.")
        int lineHits,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description(
            "LINES: maximum gap closed between two line ends that face each other; 0: none.")
        double joinGap,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description("LINES: assumed continuation of a line beyond its seen end.")
        double lineExtension,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description(
            "LINES: assumed continuation of a line beyond its seen end where the other line of its lane runs alongside; 0: same as LINE EXTENSION.")
        double laneExtension,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 6.1)
        @Description("LINES: maximum width of a lane, for LANE EXTENSION.")
        double widestLane,
    @Variable(unit = "m", min = 0, max = 10, ifAbsent = 0)
        @Description(
            "LINES: position drift of the vehicle in one second, growing with the square root of time. It widens the search for lines not seen for a while.")
        double lineWander,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 1.5)
        @Description(
            "LINES: minimum distance of such an extension from other lines: the minimum width of a lane.")
        double laneWidth,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 2.5)
        @Description(
            "LINES: distance ahead within which an existing line should be seen; a line unseen there loses confidence.")
        double doubtReach,
    @Variable(unit = "deg", min = 0, max = 360, ifAbsent = 50)
        @Description("LINES: width of the sector ahead in which unseen lines lose confidence.")
        double doubtAngle,
    @Variable(unit = "m", min = 1, max = 1000, ifAbsent = 15)
        @Description("LINES: distance from the vehicle up to which lines are published.")
        double lineReach,
    @Variable(unit = "m", min = 0, max = 10, ifAbsent = 0)
        @Description(
            "LINES: minimum distance of closed gaps from the vehicle's reference point: about half its width.")
        double clearOfVehicle,
    @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 0)
        @Description(
            "LINES: depth of the occlusion behind echoes of a scanner, where a camera cannot see the ground: apparent lines there are part of the occluding object.")
        double hiddenBehind,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description(
            "LINES: range within which a camera sees all paint. Where a line ends and the ground beyond has been seen as far as JOIN GAP, no continuation is assumed; 0: always assumed.")
        double lookReach,
    @Variable(unit = "deg", min = 0, max = 360, ifAbsent = 80)
        @Description("LINES: width of the sector ahead for LOOK REACH.")
        double lookAngle,
    @Variable(unit = "rad/s", min = 0, max = 100, ifAbsent = 100)
        @Description("LINES: maximum turn rate for using a picture: rolling shutters bend lines.")
        double steadyTurn) {
  Set<String> types() {
    Set<String> types = new HashSet<>();
    Arrays.stream(lineTypes.split(",")).map(String::trim).forEach(types::add);
    return types;
  }

  LineGaps.Reach reach() {
    return new LineGaps.Reach(
        joinGap, lineExtension, Math.max(laneExtension, lineExtension), laneWidth, widestLane);
  }
}
