package org.u2sa.planning.guidance;

import java.util.function.DoubleSupplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Line-of-sight law with integral action, for a vehicle pushed off the line by wind or current
 * (Børhaug, Pavlov, Pettersen: Integral LOS Control for Path Following of Underactuated Marine
 * Surface Vessels in the Presence of Constant Ocean Currents, CDC 2008, eq. 8; Fossen 2021, section
 * 12.4.2).
 *
 * <p>Course = bearing − atan((y + κ i) / Δ), di/dt = Δ y / ((y + κ i)² + Δ²), with cross-track
 * distance y, look-ahead Δ and gain κ. Near the line the damping ratio is ½ √(U / κ) at speed U,
 * whatever the look-ahead.
 */
final class IntegralLineOfSight implements GuidanceLaw {
  private static final String INTEGRAL = "CROSS TRACK INTEGRAL";

  private final DoubleSupplier gainMps;
  private double integralS;

  /**
   * @param gainMps κ [m/s], at least 0
   */
  IntegralLineOfSight(DoubleSupplier gainMps) {
    this.gainMps = gainMps;
  }

  @Override
  public void begin() {
    integralS = 0.0;
  }

  @Override
  public Point pointAhead(Leg leg, double lookAheadM) {
    double corrected = leg.acrossM(0.0, 0.0) + gainMps.getAsDouble() * integralS;
    double course = leg.bearingRad() - Math.atan2(corrected, lookAheadM);
    return Point.of(lookAheadM * Math.cos(course), lookAheadM * Math.sin(course), 0.0);
  }

  @Override
  public void advance(Leg leg, double lookAheadM, double stepS) {
    double across = leg.acrossM(0.0, 0.0);
    double corrected = across + gainMps.getAsDouble() * integralS;
    integralS += stepS * lookAheadM * across / (corrected * corrected + lookAheadM * lookAheadM);
  }

  @Override
  public void handOver(HandOver state) {
    state.number(INTEGRAL, integralS);
  }

  @Override
  public void takeOver(HandOver state) {
    integralS = state.number(INTEGRAL).orElse(0.0);
  }
}
