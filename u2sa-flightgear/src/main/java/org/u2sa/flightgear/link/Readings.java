package org.u2sa.flightgear.link;

import java.util.EnumMap;
import java.util.Map;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Converts FlightGear's lines to readings and back: axes and zero points. The protocol converts
 * units.
 */
final class Readings {
  private static final double FULL_CIRCLE = 2.0 * Math.PI;

  private Readings() {}

  /**
   * The reading of a line. Airspeed and engine speed, which FlightGear may report slightly below 0,
   * are clamped to 0.
   *
   * @throws IllegalArgumentException if a value cannot be published
   */
  static AircraftReading of(OutLine line, long sequence, long measuredAtMicros) {
    double heading = line.get(OutField.HEADING);
    AircraftState state = new AircraftState();
    state
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(line.get(OutField.LONGITUDE))
        .y(line.get(OutField.LATITUDE))
        .z(line.get(OutField.ALTITUDE))
        .xDot(line.get(OutField.SPEED_EAST))
        .yDot(line.get(OutField.SPEED_NORTH))
        .zDot(-line.get(OutField.SPEED_DOWN))
        .phi(line.get(OutField.ROLL))
        .theta(line.get(OutField.PITCH))
        .psi(heading >= FULL_CIRCLE ? heading - FULL_CIRCLE : heading)
        .phiDot(line.get(OutField.ROLL_RATE))
        .thetaDot(line.get(OutField.PITCH_RATE))
        .psiDot(line.get(OutField.HEADING_RATE))
        .fluidxDot(line.get(OutField.AIR_FORWARD))
        .fluidyDot(-line.get(OutField.AIR_RIGHT))
        .fluidzDot(line.get(OutField.AIR_DOWN));
    state
        .heightAboveGround(line.get(OutField.HEIGHT) - OutLine.STANDING_M)
        .calibratedAirspeed(Math.max(0.0, line.get(OutField.CALIBRATED_AIRSPEED)))
        .engineRpm(Math.max(0.0, line.get(OutField.ENGINE_SPEED)))
        .weightOnWheels(line.isSet(OutField.WEIGHT_ON_WHEEL))
        .engineStarting(line.isSet(OutField.PRIMER))
        .crashed(line.isSet(OutField.CRASHED));
    return new AircraftReading(true, sequence, measuredAtMicros, state);
  }

  /** The line FlightGear would send for an aircraft. */
  static OutLine line(AircraftState state, double elapsedS, boolean primer, long count) {
    Map<OutField, Double> values = new EnumMap<>(OutField.class);
    values.put(OutField.ELAPSED, elapsedS);
    values.put(OutField.LATITUDE, state.y().orElseThrow());
    values.put(OutField.LONGITUDE, state.x().orElseThrow());
    values.put(OutField.ALTITUDE, state.z().orElseThrow());
    values.put(OutField.HEIGHT, state.heightAboveGround().orElseThrow() + OutLine.STANDING_M);
    values.put(OutField.ROLL, state.phi().orElseThrow());
    values.put(OutField.PITCH, state.theta().orElseThrow());
    values.put(OutField.HEADING, state.psi().orElseThrow());
    values.put(OutField.ROLL_RATE, state.phiDot().orElseThrow());
    values.put(OutField.PITCH_RATE, state.thetaDot().orElseThrow());
    values.put(OutField.HEADING_RATE, state.psiDot().orElseThrow());
    values.put(OutField.SPEED_NORTH, state.yDot().orElseThrow());
    values.put(OutField.SPEED_EAST, state.xDot().orElseThrow());
    values.put(OutField.SPEED_DOWN, -state.zDot().orElseThrow());
    values.put(OutField.CALIBRATED_AIRSPEED, state.calibratedAirspeed().orElseThrow());
    values.put(OutField.AIR_FORWARD, state.fluidxDot().orElseThrow());
    values.put(OutField.AIR_RIGHT, -state.fluidyDot().orElseThrow());
    values.put(OutField.AIR_DOWN, state.fluidzDot().orElseThrow());
    values.put(OutField.ENGINE_SPEED, state.engineRpm().orElseThrow());
    values.put(OutField.WEIGHT_ON_WHEEL, state.weightOnWheels() ? 1.0 : 0.0);
    values.put(OutField.PRIMER, primer ? 1.0 : 0.0);
    values.put(OutField.CRASHED, state.crashed() ? 1.0 : 0.0);
    values.put(OutField.COUNT, (double) count);
    return OutLine.of(values);
  }
}
