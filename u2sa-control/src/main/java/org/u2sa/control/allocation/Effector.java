package org.u2sa.control.allocation;

import java.util.Optional;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.actuator.EffectCurve;

/**
 * Actuator model for allocation: its wrench as a function of the fraction of full effect, and the
 * limits of that fraction. Shares are proportional to the effect; {@link EffectCurve} converts them
 * to percentages. Immutable.
 */
public final class Effector {
  private static final double FULL_PERCENT = 100.0;

  /**
   * Prevents a rate limit that needs several steps to reach the smallest commanded effect from
   * never reaching it.
   */
  private static final double MIN_SHARE = 1.001 * EffectCurve.MIN_SHARE;

  private static final double SLOWEST = 0.1; // of the reference speed; the model is invalid below

  private final String name;
  private final double[] effect; // X, Y, Z [N], K, M, N [N m] at full effect
  private final double astern; // ratio of the effect at −100 % to that at +100 %, 0…∞
  private final double lowest; // share
  private final double highest; // share
  private final double ratePerS; // [%/s]
  private final double referenceSpeed; // [m/s]; 0: its effect does not depend on speed
  private final EffectCurve curve;

  private Effector(ActuatorAnnouncement announced, double[] effect, double astern) {
    name = announced.actuatorName();
    this.effect = effect;
    this.astern = astern;
    ratePerS = announced.rateLimit().orElse(Double.POSITIVE_INFINITY);
    referenceSpeed = announced.referenceSpeed().orElse(0.0);
    curve = EffectCurve.of(announced);
    lowest = share(announced.minimum());
    highest = share(announced.maximum());
  }

  /**
   * Creates an effector from an announcement; empty without a numeric effect. The remaining share
   * is {@link ActuatorAnnouncement#available}. Of a reverse effect that is not exactly opposite,
   * only the component along that line counts.
   */
  public static Optional<Effector> of(ActuatorAnnouncement announced) {
    return of(announced, announced.available().orElse(FULL_PERCENT) / FULL_PERCENT);
  }

  /** Creates the healthy effector, regardless of the actuator's remaining effectiveness. */
  public static Optional<Effector> ofSound(ActuatorAnnouncement announced) {
    return of(announced, 1.0);
  }

  private Effector(Effector sound, double left) {
    name = sound.name;
    effect = sound.effect.clone();
    for (int i = 0; i < effect.length; i++) {
      effect[i] *= left;
    }
    astern = sound.astern;
    lowest = sound.lowest;
    highest = sound.highest;
    ratePerS = sound.ratePerS;
    referenceSpeed = sound.referenceSpeed;
    curve = sound.curve;
  }

  /**
   * Copy with a fraction of the effect.
   *
   * @param left remaining share, above 0…1
   */
  public Effector weakened(double left) {
    return new Effector(this, left);
  }

  private static Optional<Effector> of(ActuatorAnnouncement announced, double left) {
    double[] effect = wrench(announced.force(), announced.moment(), left);
    double square = dot(effect, effect);
    if (!(square > 0.0)) {
      return Optional.empty();
    }
    boolean isSymmetric = announced.reverseForce().isEmpty() && announced.reverseMoment().isEmpty();
    double[] reverse = wrench(announced.reverseForce(), announced.reverseMoment(), left);
    double astern = isSymmetric ? 1.0 : Math.max(0.0, -dot(reverse, effect) / square);
    return Optional.of(new Effector(announced, effect, astern));
  }

  private static double[] wrench(Optional<Point> force, Optional<Point> moment, double left) {
    Point f = force.orElse(Point.ORIGIN);
    Point m = moment.orElse(Point.ORIGIN);
    double[] wrench = {f.x(), f.y(), f.z(), m.x(), m.y(), m.z()};
    for (int i = 0; i < wrench.length; i++) {
      wrench[i] *= left;
    }
    return wrench;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0.0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /** The actuator's name. */
  public String name() {
    return name;
  }

  /** Force [N] or moment [N m] at full effect, at the reference speed. */
  public double effect(DegreeOfFreedom axis) {
    return effect[axis.ordinal()];
  }

  /** Speed for the effect [m/s], as of a rudder; 0 if it does not depend on speed. */
  double referenceSpeed() {
    return referenceSpeed;
  }

  /** Scale of the effect at a speed through air or water [m/s]; NaN for an unknown speed. */
  double scaleAt(double speedMps) {
    if (referenceSpeed == 0.0 || Double.isNaN(speedMps)) {
      return 1.0;
    }
    double ratio = Math.max(SLOWEST, Math.abs(speedMps) / referenceSpeed);
    return ratio * ratio;
  }

  /** Minimum share; 0, or below for bidirectional actuators. */
  double lowest() {
    return lowest;
  }

  /** Maximum share; 1 for an actuator that accepts +100 %. */
  double highest() {
    return highest;
  }

  /** Converts a share to a percentage. */
  double percent(double share) {
    if (share >= 0.0) {
      return curve.percent(share);
    }
    return astern > 0.0 ? curve.percent(share / astern) : 0.0;
  }

  /** Converts a percentage to a share. */
  double share(double percent) {
    double share = curve.share(percent);
    return share < 0.0 ? share * astern : share;
  }

  /**
   * Force at a percentage, along the effect's own line [N], as announced for the healthy actuator.
   */
  double forceN(double percent) {
    double share = curve.share(percent);
    return share * (share < 0.0 ? curve.reverseN() : curve.forwardN());
  }

  /** Minimum share reachable from a percentage within a time [s]. */
  double lowestFrom(double percent, double stepS) {
    double reached = share(stand(percent, -1.0) - ratePerS * stepS);
    return Math.max(lowest, reached < 0.0 ? Math.min(reached, -MIN_SHARE * astern) : reached);
  }

  /** Maximum share reachable from a percentage within a time [s]. */
  double highestFrom(double percent, double stepS) {
    double reached = share(stand(percent, 1.0) + ratePerS * stepS);
    return Math.min(highest, reached > 0.0 ? Math.max(reached, MIN_SHARE) : reached);
  }

  /** Skips the dead band. */
  private double stand(double percent, double sign) {
    return Math.abs(percent) <= curve.deadband() ? sign * curve.deadband() : percent;
  }
}
