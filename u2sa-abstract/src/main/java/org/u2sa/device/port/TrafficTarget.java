package org.u2sa.device.port;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;

/**
 * An aircraft or ship reported by a receiver or radar. Unknown values are empty.
 *
 * @param id ID of the target, independent of the receiver: the ICAO address as six hexadecimal
 *     digits, the MMSI, or a track number
 * @param name call sign or ship's name; empty text if unknown
 * @param kind kind of target, such as {@code aircraft}; empty text if unknown
 * @param heardAtMicros time at which the position was received or measured [µs of the run's clock]
 * @param latitudeDeg WGS 84 [deg], north positive
 * @param longitudeDeg WGS 84 [deg], east positive
 * @param altitudeM altitude above mean sea level, or pressure altitude for 1013.25 hPa [m]
 * @param isPressureAltitude whether it is a pressure altitude for 1013.25 hPa
 * @param velocity velocity over ground: east, north, up [m/s]
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
