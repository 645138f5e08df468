package org.u2sa.device.port;

import java.util.OptionalDouble;

/**
 * Pressure of the surrounding air or water at one time.
 *
 * @param measuredAtMicros time of measurement, or arrival of its bytes [µs of the run's clock]
 * @param pascals absolute pressure [Pa]; relative to the surface's air pressure for a gauge
 *     documented as such
 * @param temperatureK temperature of the fluid [K]; empty if not measured
 */
public record Pressure(long measuredAtMicros, double pascals, OptionalDouble temperatureK)
    implements Device.Reading {}
