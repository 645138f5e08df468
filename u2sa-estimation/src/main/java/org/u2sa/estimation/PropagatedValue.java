package org.u2sa.estimation;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.u2sa.interfaces.time.Clock;

/** A value that is pulled by its measurements and propagated by its rate. Not thread-safe. */
final class PropagatedValue {
  private static final double SLOPE_S = 0.5; // filter of an unmeasured rate

  private double value;
  private double sigma;
  private double rate;
  private double rateSigma;
  private double drift; // error of the rate, integrated since the last measurement
  private double slope; // mean change of the measured values
  private boolean hasValue;
  private boolean hasRate;
  private boolean hasSlope;
  private final Map<String, Long> pulls = new TreeMap<>(); // last measurement by source [µs]
  private long pulledMicros;
  private long rateMicros;

  /**
   * Propagates the value.
   *
   * @param perUnit units of the value per unit of the rate times a second
   */
  void moveOn(double seconds, double perUnit) {
    value += moved(seconds, perUnit);
    drift += hasRate ? rateSigma * seconds : 0.0;
  }

  void rate(double newRate, double newSigma, long micros) {
    if (hasRate && micros < rateMicros) {
      return; // a newer rate is known
    }
    rate = newRate;
    rateSigma = newSigma;
    hasRate = true;
    rateMicros = micros;
  }

  /** Change of the value over that time at the current rate. */
  double moved(double seconds, double perUnit) {
    return hasRate ? rate * seconds * perUnit : 0.0;
  }

  /**
   * Each source is weighted by the time since its own previous measurement, because any source may
   * be late. Without a rate, the value would lag behind its measurements: it follows at once.
   */
  void pull(String source, double apart, double newSigma, double timeS, long micros) {
    Long before = pulls.put(source, micros);
    double seconds =
        Math.max(0.0, Clock.seconds(micros - (before == null ? pulledMicros : before)));
    double share = hasValue && hasRate && timeS > 0.0 ? 1.0 - Math.exp(-seconds / timeS) : 1.0;
    if (!hasRate && hasValue && micros > pulledMicros) {
      double sinceS = Clock.seconds(micros - pulledMicros);
      hasSlope = true;
      slope += (1.0 - Math.exp(-sinceS / SLOPE_S)) * (apart / sinceS - slope);
    }
    value += share * apart;
    sigma = newSigma;
    drift = 0.0;
    pulledMicros = hasValue ? Math.max(pulledMicros, micros) : micros;
    hasValue = true;
  }

  boolean hasValue() {
    return hasValue;
  }

  double value() {
    return value;
  }

  /** Standard deviation of the latest measurement, increased by the rate's error since. */
  double sigma() {
    return Math.hypot(sigma, drift);
  }

  boolean hasRate() {
    return hasRate;
  }

  double rate() {
    return rate;
  }

  /** Mean change of the measured values per second, if no rate is measured. */
  OptionalDouble slope() {
    return hasSlope ? OptionalDouble.of(slope) : OptionalDouble.empty();
  }

  /** Standard deviation of {@link #slope} due to white noise of the values. */
  double slopeSigma() {
    return sigma / SLOPE_S;
  }

  /**
   * Discards what is older than a span.
   *
   * @param mostDrift drift up to which a measured rate replaces a fresh value
   */
  void forget(long now, long staleMicros, double mostDrift) {
    boolean isFresh = now - pulledMicros <= staleMicros;
    hasRate &= now - rateMicros <= staleMicros;
    hasValue &= isFresh || hasRate && drift < mostDrift;
    hasSlope &= isFresh && !hasRate;
    slope = hasSlope ? slope : 0.0;
    pulls.values().removeIf(micros -> now - micros > staleMicros);
  }
}
