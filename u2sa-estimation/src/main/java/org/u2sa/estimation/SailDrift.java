package org.u2sa.estimation;

import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;

/**
 * Turns measured wind into the sideways drift of a boat through the water (thesis 4.2.1.1): the
 * wind pushes the side above the water, the hull's drag resists. Angular motion is ignored.
 */
final class SailDrift {
  private static final double HALF_AIR_KG_PER_M3 = 0.6;
  private static final double SIDE = 0.8; // drag coefficient of a boat's side (Fossen 2011, 8.1)
  private static final double UNKNOWN_SHARE = 0.5; // 1 σ of the drift: coefficients are estimates
  private static final double LONGEST_S = 1.0; // after a longer gap the drift counts as steady

  /**
   * Properties of the boat.
   *
   * @param sailAreaM2 side area above the water
   * @param displacementKg mass, including the added mass in sway
   * @param drag linear drag sideways through the water [N s/m], above 0
   * @param squareDrag quadratic drag [N s²/m²]
   */
  record Hull(double sailAreaM2, double displacementKg, double drag, double squareDrag) {}

  private final Set<String> windSensors;
  private final Hull hull;
  private final double slipSigmaMps;
  private final long intervalMicros;
  private double driftMps; // in the direction of the message's y axis
  private long micros = Long.MIN_VALUE; // of the newest wind
  private long usedMicros = Long.MIN_VALUE;

  /**
   * @param windSensors names of the wind sensors used
   * @param slipSigmaMps sideways speed from other causes, 1 σ
   * @param intervalS time between two drifts
   */
  SailDrift(Set<String> windSensors, Hull hull, double slipSigmaMps, double intervalS) {
    this.windSensors = windSensors;
    this.hull = hull;
    this.slipSigmaMps = slipSigmaMps;
    intervalMicros = Clock.micros(intervalS);
  }

  /**
   * Converts a wind sensor's message to the drift, as a speed through the water; returns other
   * messages unchanged. A drift within the interval is omitted.
   */
  StateInformation throughWater(StateInformation sensed) {
    OptionalDouble wind = sensed.fluidyDot(); // of the boat through the air
    boolean isNamed =
        windSensors.contains(sensed.sensorName())
            || windSensors.contains(SensorParts.sensor(sensed.sensorName()));
    if (!isNamed || wind.isEmpty()) {
      return sensed;
    }
    long now = sensed.timestamp().orElseThrow();
    blow(wind.getAsDouble(), now);
    StateInformation drift = new StateInformation().sensorName(sensed.sensorName());
    drift.referenceFrame(sensed.referenceFrame()).timestamp(now);
    if (usedMicros == Long.MIN_VALUE || now - usedMicros >= intervalMicros) {
      usedMicros = now;
      double sigma = Math.hypot(slipSigmaMps, UNKNOWN_SHARE * driftMps);
      drift.fluidyDot(driftMps).fluidyDotSigma(sigma);
    }
    return drift;
  }

  private void blow(double airMps, long now) {
    double newtons = -HALF_AIR_KG_PER_M3 * SIDE * hull.sailAreaM2() * airMps * Math.abs(airMps);
    double elapsedS = micros == Long.MIN_VALUE ? LONGEST_S : Clock.seconds(now - micros);
    double dt = Math.max(0.0, Math.min(LONGEST_S, elapsedS));
    double resistance = hull.drag() + hull.squareDrag() * Math.abs(driftMps);
    driftMps =
        (hull.displacementKg() * driftMps + dt * newtons)
            / (hull.displacementKg() + dt * resistance);
    micros = now;
  }
}
