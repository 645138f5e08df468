package org.u2sa.flightgear.link;

import java.util.EnumMap;
import java.util.Map;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;

/**
 * FlightGear's lines as readings and back: axes and zero points; units are the protocol's concern.
 */
final class Readings {
  private static final double FULL_CIRCLE = 2.0 * Math.PI;

  private Readings() {}

  static AircraftReading of(OutLine line, long sequence, long measuredAtMicros) {
    double heading = line.get(OutField.HEADING);
    return new AircraftReading(
        true,
        sequence,
        measuredAtMicros,
        line.get(OutField.LONGITUDE),
        line.get(OutField.LATITUDE),
        line.get(OutField.ALTITUDE),
        line.get(OutField.HEIGHT) - OutLine.STANDING_M,
        line.get(OutField.ROLL),
        line.get(OutField.PITCH),
        heading >= FULL_CIRCLE ? heading - FULL_CIRCLE : heading,
        line.get(OutField.ROLL_RATE),
        line.get(OutField.PITCH_RATE),
        line.get(OutField.HEADING_RATE),
        line.get(OutField.SPEED_NORTH),
        line.get(OutField.SPEED_EAST),
        -line.get(OutField.SPEED_DOWN),
        line.get(OutField.AIR_FORWARD),
        -line.get(OutField.AIR_RIGHT),
        line.get(OutField.AIR_DOWN),
        line.get(OutField.CALIBRATED_AIRSPEED),
        line.get(OutField.ENGINE_SPEED),
        line.isSet(OutField.WEIGHT_ON_WHEEL),
        line.isSet(OutField.PRIMER),
        line.isSet(OutField.CRASHED));
  }

  /** The same reading of an aircraft that is not there any more. */
  static AircraftReading lost(AircraftReading last) {
    return new AircraftReading(
        false,
        last.sequence(),
        last.measuredAtMicros(),
        last.longitudeDeg(),
        last.latitudeDeg(),
        last.altitudeM(),
        last.heightAboveGroundM(),
        last.rollRad(),
        last.pitchRad(),
        last.headingRad(),
        last.rollRateRadPerS(),
        last.pitchRateRadPerS(),
        last.headingRateRadPerS(),
        last.northMps(),
        last.eastMps(),
        last.upMps(),
        last.airForwardMps(),
        last.airLeftMps(),
        last.airDownMps(),
        last.calibratedAirspeedMps(),
        last.engineRpm(),
        last.weightOnWheels(),
        last.engineStarting(),
        last.crashed());
  }

  /** What FlightGear would say of an aircraft. */
  static OutLine line(AircraftReading reading, double elapsedS, boolean primer, long count) {
    Map<OutField, Double> values = new EnumMap<>(OutField.class);
    values.put(OutField.ELAPSED, elapsedS);
    values.put(OutField.LATITUDE, reading.latitudeDeg());
    values.put(OutField.LONGITUDE, reading.longitudeDeg());
    values.put(OutField.ALTITUDE, reading.altitudeM());
    values.put(OutField.HEIGHT, reading.heightAboveGroundM() + OutLine.STANDING_M);
    values.put(OutField.ROLL, reading.rollRad());
    values.put(OutField.PITCH, reading.pitchRad());
    values.put(OutField.HEADING, reading.headingRad());
    values.put(OutField.ROLL_RATE, reading.rollRateRadPerS());
    values.put(OutField.PITCH_RATE, reading.pitchRateRadPerS());
    values.put(OutField.HEADING_RATE, reading.headingRateRadPerS());
    values.put(OutField.SPEED_NORTH, reading.northMps());
    values.put(OutField.SPEED_EAST, reading.eastMps());
    values.put(OutField.SPEED_DOWN, -reading.upMps());
    values.put(OutField.CALIBRATED_AIRSPEED, reading.calibratedAirspeedMps());
    values.put(OutField.AIR_FORWARD, reading.airForwardMps());
    values.put(OutField.AIR_RIGHT, -reading.airLeftMps());
    values.put(OutField.AIR_DOWN, reading.airDownMps());
    values.put(OutField.ENGINE_SPEED, reading.engineRpm());
    values.put(OutField.WEIGHT_ON_WHEEL, reading.weightOnWheels() ? 1.0 : 0.0);
    values.put(OutField.PRIMER, primer ? 1.0 : 0.0);
    values.put(OutField.CRASHED, reading.crashed() ? 1.0 : 0.0);
    values.put(OutField.COUNT, (double) count);
    return OutLine.of(values);
  }
}
