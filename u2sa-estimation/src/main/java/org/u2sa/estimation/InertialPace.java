package org.u2sa.estimation;

import java.util.HashMap;
import java.util.Map;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.interfaces.time.Clock;

/**
 * When the inertial sensor that drives the prediction speaks next. A state that another sensor's
 * message triggers shortly before it lacks a whole interval of the vehicle's turning, which is
 * enough to make a multirotor's attitude control oscillate.
 */
final class InertialPace {
  private static final double NEAR = 0.5; // part of an interval

  private final Map<String, Long> heardMicros = new HashMap<>(); // by inertial source

  /** Records a measurement that arrives now. */
  void hear(Measurement measurement, long nowMicros) {
    if (measurement.isWhole(SensedQuantity.BODY_RATES)) {
      heardMicros.put(measurement.source(), nowMicros);
    }
  }

  /**
   * Whether the next sample is expected about now, so that the state had better wait for it: for
   * half an interval at most, and for half the time between two states.
   *
   * @param periodS time between two states
   */
  boolean isNextDue(ErrorStateFilter filter, long nowMicros, double periodS) {
    Long before = filter.inertialSource().map(heardMicros::get).orElse(null);
    if (before == null) {
      return false;
    }
    double intervalS = filter.inertialIntervalS();
    double untilS = intervalS - Clock.seconds(nowMicros - before);
    return Math.abs(untilS) <= NEAR * Math.min(intervalS, periodS);
  }
}
