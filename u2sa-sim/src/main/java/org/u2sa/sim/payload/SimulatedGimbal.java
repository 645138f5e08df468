package org.u2sa.sim.payload;

import org.u2sa.device.payload.Gimbal;
import org.u2sa.sim.device.SimulatedPayload;

/** A gimbal whose axes have limits, a maximum rate and a lag. It starts straight ahead. */
public final class SimulatedGimbal extends SimulatedPayload<Gimbal.Pointing> implements Gimbal {
  private final SimulatedJoint pan;
  private final SimulatedJoint tilt;

  /**
   * Limits and dynamics.
   *
   * @param rateHz readings per second
   * @param panRad largest pan angle, to either side [rad]
   * @param lowestTiltRad lowest tilt angle [rad]
   * @param highestTiltRad highest tilt angle [rad]
   * @param maxRateRadPerS maximum rate of either axis [rad/s]
   * @param lagS time constant of either axis [s]
   */
  public record Drive(
      double rateHz,
      double panRad,
      double lowestTiltRad,
      double highestTiltRad,
      double maxRateRadPerS,
      double lagS) {}

  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public SimulatedGimbal(Drive drive) {
    super(drive.rateHz(), 0.0);
    pan = joint(drive, -drive.panRad(), drive.panRad());
    tilt = joint(drive, drive.lowestTiltRad(), drive.highestTiltRad());
  }

  private static SimulatedJoint joint(Drive drive, double lowestRad, double highestRad) {
    return new SimulatedJoint(
        new SimulatedJoint.Properties(lowestRad, highestRad, drive.maxRateRadPerS(), drive.lagS()));
  }

  @Override
  protected void advance(long nowMicros) {
    pan.advance(nowMicros);
    tilt.advance(nowMicros);
  }

  @Override
  protected Pointing sense(long stampMicros) {
    return new Pointing(stampMicros, pan.angleRad(), tilt.angleRad());
  }

  @Override
  public void point(double panRad, double tiltRad) {
    pan.turn(panRad);
    tilt.turn(tiltRad);
  }

  @Override
  public void leave() {
    // keeps its angles
  }

  @Override
  public void close() {
    // keeps its angles
  }
}
