package org.u2sa.sim.payload;

import java.util.OptionalDouble;
import org.u2sa.device.port.Servo;
import org.u2sa.sim.device.SimulatedPayload;

/**
 * A servo of a payload, such as a joint of an arm, with limits, a maximum rate and a lag. It starts
 * at mid-travel and measures its angle.
 */
public final class SimulatedServo extends SimulatedPayload<Servo.Position> implements Servo {
  private final SimulatedJoint joint;

  /**
   * @param rateHz readings per second
   * @param lowestRad lowest angle [rad]
   * @param highestRad highest angle [rad]
   * @param maxRateRadPerS maximum rate [rad/s]
   * @param lagS time constant [s]
   * @throws IllegalArgumentException if a value is outside its range
   */
  public SimulatedServo(
      double rateHz, double lowestRad, double highestRad, double maxRateRadPerS, double lagS) {
    super(rateHz, 0.0);
    joint =
        new SimulatedJoint(
            new SimulatedJoint.Properties(lowestRad, highestRad, maxRateRadPerS, lagS));
  }

  @Override
  protected void advance(long nowMicros) {
    joint.advance(nowMicros);
  }

  @Override
  protected Position sense(long stampMicros) {
    return new Position(stampMicros, OptionalDouble.of(joint.angleRad()));
  }

  @Override
  public void turn(double angleRad) {
    joint.turn(angleRad);
  }

  @Override
  public void leave() {
    // keeps its angle
  }

  @Override
  public void close() {
    // keeps its angle
  }
}
