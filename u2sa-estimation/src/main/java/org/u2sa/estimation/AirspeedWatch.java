package org.u2sa.estimation;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Compares the airspeed of an aircraft with its ground speed and the wind of the last minute, or
 * with the wind before its readings became those of a blocked pitot tube. A blocked tube reads too
 * low in a descent and too high in a climb: at 18 m/s it loses its whole reading within 17 m.
 * Single readings do not reveal this, because the estimated wind follows each of them, as it must
 * to follow gusts.
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
  private static final double PROOF_M = 15.0; // at the same speed, changes a blocked reading a lot
  private static final double ACROSS_S = 10.0; // to learn the wind from drift
  private static final double LONGEST_S = 0.5; // maximum time between two estimates
  private static final double SIGMA_MPS = 2.0; // of an airspeed computed from wind and ground speed

  private final Consumer<String> trouble;
  private final TrappedPressure pressure = new TrappedPressure();
  private Point wind = Point.ORIGIN; // north, east
  private double learntS;
  private Point overGround = Point.ORIGIN; // north, east, of the newest estimate
  private Point ahead = Point.ORIGIN; // the way it heads
  private double altitudeM;
  private boolean isSure;
  private long seenMicros = Long.MIN_VALUE;
  private boolean isContradicted;
  private double contradictedM; // level of the pressure when contradicted
  private long sinceMicros = Long.MIN_VALUE; // start of disagreement, or of agreement

  /**
   * @param trouble receives messages for the operator
   */
  AirspeedWatch(Consumer<String> trouble) {
    this.trouble = trouble;
  }

  /** Updates the wind: by drift alone while the airspeed is contradicted. */
  void see(Estimate estimate) {
    long micros = estimate.micros();
    double dt = seenMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(micros - seenMicros);
    seenMicros = micros;
    overGround = Point.of(estimate.velocityMps(0), estimate.velocityMps(1), 0.0);
    isSure =
        estimate.hasHeading()
            && estimate.hasFlow()
            && estimate.velocitySigmaMps(0) < SURE_MPS
            && estimate.velocitySigmaMps(1) < SURE_MPS
            && overGround.distance() > FLIES_MPS;
    if (isSure) {
      ahead = Point.polar(estimate.psi(), 0.0, 1.0);
      altitudeM = estimate.altitudeM();
      learn(estimate, Math.max(0.0, Math.min(LONGEST_S, dt)));
    }
  }

  private void learn(Estimate estimate, double dt) {
    if (isContradicted) {
      Point right = Point.of(-ahead.y(), ahead.x(), 0.0); // the air comes from ahead
      wind = wind.plus(right.times(dt / ACROSS_S * overGround.minus(wind).dot(right)));
      return;
    }
    learntS = Math.min(WIND_S, learntS + dt);
    double share = learntS > 0.0 ? dt / learntS : 0.0;
    Point flow = Point.of(estimate.flowMps(0), estimate.flowMps(1), 0.0);
    wind = wind.plus(flow.minus(wind).times(share));
  }

  /** The message, or a copy with the expected airspeed in place of a contradicted one. */
  StateInformation checked(StateInformation sensed) {
    OptionalDouble airspeed = sensed.fluidxDot();
    if (airspeed.isEmpty() || !isSure) {
      return sensed;
    }
    pressure.see(airspeed.getAsDouble(), altitudeM, wind);
    boolean isLikelyBlocked = !isContradicted && pressure.isLikely();
    if (!isLikelyBlocked && learntS < KNOWN_S) {
      sinceMicros = Long.MIN_VALUE;
      return sensed;
    }
    Point known = isLikelyBlocked ? pressure.windBefore() : wind;
    double expected = overGround.minus(known).dot(ahead);
    double off = airspeed.getAsDouble() - expected;
    double limit = Math.max(MIN_OFF_MPS, OFF_SHARE * expected);
    if (isContradicted) {
      boolean isAsThen = Math.abs(pressure.levelM() - contradictedM) < PROOF_M;
      judge(sensed, off, isAsThen || Math.abs(off) > limit / 2.0);
    } else {
      judge(sensed, off, Math.abs(off) > limit);
    }
    if (!isContradicted) {
      return sensed;
    }
    wind = known;
    learntS = Math.max(learntS, KNOWN_S);
    return sensed.copy().fluidxDot(expected).fluidxDotSigma(SIGMA_MPS);
  }

  /**
   * @param isOff whether the reading is off or, once contradicted, does not differ from that of a
   *     tube blocked then
   */
  private void judge(StateInformation sensed, double offMps, boolean isOff) {
    long now = sensed.timestamp().orElseThrow();
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
    contradictedM = pressure.levelM();
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
    state.number("WIND NORTH", wind.x()).number("WIND EAST", wind.y());
    state.number("WIND LEARNT", learntS).flag("AIRSPEED CONTRADICTED", isContradicted);
    state.number("CONTRADICTED LEVEL", contradictedM);
  }

  void takeOver(HandOver state) {
    double north = state.number("WIND NORTH").orElse(0.0);
    wind = Point.of(north, state.number("WIND EAST").orElse(0.0), 0.0);
    learntS = state.number("WIND LEARNT").orElse(0.0);
    isContradicted = state.flag("AIRSPEED CONTRADICTED");
    contradictedM = state.number("CONTRADICTED LEVEL").orElse(0.0);
  }
}
