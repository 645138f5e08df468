package org.u2sa.estimation;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.handover.HandOver;

/**
 * Compares the airspeed of an aircraft with its ground speed and the wind of the last minute. A
 * blocked pitot tube reads too low in a descent and too high in a climb: at 18 m/s it loses its
 * whole reading within 17 m. Single readings do not reveal this, because the estimated wind follows
 * each of them, as it must to follow gusts.
 */
final class AirspeedWatch {
  private static final double WIND_S = 60.0; // time over which the wind is averaged
  private static final double KNOWN_S = 20.0; // flight time after which the wind is known
  private static final double FLIES_MPS = 10.0; // over ground
  private static final double SURE_MPS = 1.0; // maximum sigma of a ground speed to compare with
  private static final double MIN_OFF_MPS = 6.0; // gusts and the wind's change with height
  private static final double OFF_SHARE = 0.3; // fraction of the airspeed
  private static final double OFF_S = 1.5; // until the airspeed counts as contradicted
  private static final double AGREES_S = 10.0; // until the airspeed is trusted again
  private static final double LONGEST_S = 0.5; // maximum time between two estimates
  private static final double SIGMA_MPS = 2.0; // of an airspeed computed from wind and ground speed

  private final Consumer<String> trouble;
  private final WindInTurns turns = new WindInTurns(); // used while contradicted
  private double windNorthMps;
  private double windEastMps;
  private double learntS;
  private double northMps; // ground speed of the newest estimate
  private double eastMps;
  private double psi;
  private boolean isSure;
  private long seenMicros = Long.MIN_VALUE;
  private boolean isContradicted;
  private long sinceMicros = Long.MIN_VALUE; // start of disagreement, or of agreement

  /**
   * @param trouble receives messages for the operator
   */
  AirspeedWatch(Consumer<String> trouble) {
    this.trouble = trouble;
  }

  /** Updates the wind unless the airspeed is contradicted. */
  void see(Estimate estimate) {
    long micros = estimate.micros();
    double dt = seenMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(micros - seenMicros);
    seenMicros = micros;
    northMps = estimate.velocityMps(0);
    eastMps = estimate.velocityMps(1);
    isSure =
        estimate.hasHeading()
            && estimate.hasFlow()
            && estimate.velocitySigmaMps(0) < SURE_MPS
            && estimate.velocitySigmaMps(1) < SURE_MPS
            && Math.hypot(northMps, eastMps) > FLIES_MPS;
    if (isSure) {
      psi = estimate.psi();
      learn(estimate, Math.max(0.0, Math.min(LONGEST_S, dt)));
    }
  }

  private void learn(Estimate estimate, double dt) {
    if (isContradicted) {
      return;
    }
    learntS = Math.min(WIND_S, learntS + dt);
    double share = learntS > 0.0 ? dt / learntS : 0.0;
    windNorthMps += share * (estimate.flowMps(0) - windNorthMps);
    windEastMps += share * (estimate.flowMps(1) - windEastMps);
  }

  /** The message, or a copy with the expected airspeed in place of a contradicted one. */
  StateInformation checked(StateInformation sensed) {
    OptionalDouble airspeed = sensed.fluidxDot();
    if (airspeed.isEmpty() || !isSure || learntS < KNOWN_S) {
      return sensed;
    }
    double expected =
        (northMps - windNorthMps) * Math.cos(psi) + (eastMps - windEastMps) * Math.sin(psi);
    double limit = Math.max(MIN_OFF_MPS, OFF_SHARE * expected);
    double off = airspeed.getAsDouble() - expected;
    judge(sensed, off, isContradicted ? limit / 2.0 : limit);
    if (isContradicted) {
      doubtWind(sensed, airspeed.getAsDouble());
    }
    return isContradicted ? sensed.copy().fluidxDot(expected).fluidxDotSigma(SIGMA_MPS) : sensed;
  }

  /** If the reading implies one wind on different headings, the wind has changed instead. */
  private void doubtWind(StateInformation sensed, double airspeedMps) {
    long now = sensed.timestamp().orElseThrow();
    double north = northMps - airspeedMps * Math.cos(psi);
    turns.see(psi, north, eastMps - airspeedMps * Math.sin(psi), now);
    turns
        .agreed(now)
        .ifPresent(
            wind -> {
              windNorthMps = wind.x();
              windEastMps = wind.y();
              learntS = KNOWN_S;
              isContradicted = false;
              sinceMicros = Long.MIN_VALUE;
              trouble.accept(sensed.sensorName() + " agrees with ground speed and another wind");
            });
  }

  private void judge(StateInformation sensed, double offMps, double limitMps) {
    long now = sensed.timestamp().orElseThrow();
    boolean isOff = Math.abs(offMps) > limitMps;
    if (isOff == isContradicted) {
      sinceMicros = Long.MIN_VALUE; // unchanged
      return;
    }
    sinceMicros = sinceMicros == Long.MIN_VALUE ? now : sinceMicros;
    if (Clock.seconds(now - sinceMicros) < (isContradicted ? AGREES_S : OFF_S)) {
      return;
    }
    sinceMicros = Long.MIN_VALUE;
    isContradicted = isOff;
    turns.clear();
    trouble.accept(
        isContradicted
            ? String.format(
                Locale.ROOT,
                "%s contradicts ground speed and wind by %.0f m/s and is replaced; is the tube blocked?",
                sensed.sensorName(),
                offMps)
            : sensed.sensorName() + " agrees with ground speed and wind again");
  }

  void handOver(HandOver state) {
    state.number("WIND NORTH", windNorthMps).number("WIND EAST", windEastMps);
    state.number("WIND LEARNT", learntS).flag("AIRSPEED CONTRADICTED", isContradicted);
  }

  void takeOver(HandOver state) {
    windNorthMps = state.number("WIND NORTH").orElse(0.0);
    windEastMps = state.number("WIND EAST").orElse(0.0);
    learntS = state.number("WIND LEARNT").orElse(0.0);
    isContradicted = state.flag("AIRSPEED CONTRADICTED");
  }
}
