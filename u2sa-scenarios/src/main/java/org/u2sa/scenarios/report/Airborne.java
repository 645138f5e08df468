package org.u2sa.scenarios.report;

import java.util.List;
import java.util.OptionalDouble;

/**
 * The extremes of the part of a flight that was in the air: from screen height on, while no wheel
 * carries weight.
 */
record Airborne(boolean tookOff, OptionalDouble maxBankRad, OptionalDouble minAirspeedMps) {

  static Airborne of(RunPlan plan, List<TrackSample> track) {
    if (track.isEmpty()) {
      return new Airborne(false, OptionalDouble.empty(), OptionalDouble.empty());
    }
    double ground = plan.home().map(StartPlace::altitudeM).orElse(track.get(0).altitudeM());
    boolean tookOff = false;
    double bank = 0.0;
    double airspeed = Double.POSITIVE_INFINITY;
    for (TrackSample sample : track) {
      if (sample.flight().isEmpty() || sample.flight().get().onGround()) {
        continue;
      }
      TrackSample.Flight flight = sample.flight().get();
      tookOff |= sample.altitudeM() - ground >= RunScorer.SCREEN_HEIGHT_M;
      if (tookOff) {
        bank = Math.max(bank, Math.abs(flight.rollRad()));
        airspeed = Math.min(airspeed, flight.calibratedAirspeedMps());
      }
    }
    return new Airborne(
        tookOff,
        tookOff ? OptionalDouble.of(bank) : OptionalDouble.empty(),
        tookOff ? OptionalDouble.of(airspeed) : OptionalDouble.empty());
  }
}
