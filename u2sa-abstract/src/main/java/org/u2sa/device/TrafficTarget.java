package org.u2sa.device;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * One aircraft or ship that a receiver or a radar knows of. What it does not say is empty.
 *
 * @param id the same for each report of one target, and of whoever reports it: the ICAO address as
 *     six hexadecimal digits, the MMSI, a track's number
 * @param name call sign or ship's name; empty text if unknown
 * @param kind what it is, such as {@code aircraft}; empty text if unknown
 * @param heardAtMicros when the position was heard or measured [µs of the run's clock]
 * @param latitudeDeg WGS 84 [deg], north positive
 * @param longitudeDeg WGS 84 [deg], east positive
 * @param altitudeM above mean sea level [m], or by the setting 1013.25 hPa
 * @param isPressureAltitude whether the altitude is that by the setting 1013.25 hPa
 * @param velocity over ground: east, north, up [m/s]
 * @param horizontalSigmaM standard deviation of the position along each horizontal axis [m]
 */
public record TrafficTarget(
    String id,
    String name,
    String kind,
    long heardAtMicros,
    double latitudeDeg,
    double longitudeDeg,
    OptionalDouble altitudeM,
    boolean isPressureAltitude,
    Optional<Point> velocity,
    OptionalDouble horizontalSigmaM) {}
