package org.u2sa.device;

import java.util.OptionalDouble;

/**
 * Pressure of the air or water around a device at one moment.
 *
 * @param measuredAtMicros when it was measured, or its bytes arrived [µs of the run's clock]
 * @param pascals against vacuum [Pa]; against the air at the surface for a gauge that says so
 * @param temperatureK of the fluid [K]; empty if it is not measured
 */
public record Pressure(long measuredAtMicros, double pascals, OptionalDouble temperatureK)
    implements Device.Reading {}
