package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * What a magnetometer on a level vehicle measures, and the heading that comes of it: the earth's
 * field and what disturbs it at this place, through the iron of the vehicle and the currents of its
 * motors.
 */
public final class CompassModel {
  private static final double TURN_RAD = 2.0 * Math.PI;

  private final CompassParameters p;
  private final Random noise;

  /** Takes the stream {@code compass}. */
  public CompassModel(CompassParameters parameters, NoiseStreams streams) {
    this.p = parameters;
    this.noise = streams.of("compass");
  }

  /** Magnetic heading [rad, 0…2π) of a vehicle that moves like this among these fields. */
  public double sample(VehicleTruth truth, Disturbance field) {
    double east = p.horizontalUt() * StrictMath.sin(p.declinationRad()) + field.eastUt();
    double north = p.horizontalUt() * StrictMath.cos(p.declinationRad()) + field.northUt();
    double sin = StrictMath.sin(truth.headingRad());
    double cos = StrictMath.cos(truth.headingRad());
    double forward = north * cos + east * sin;
    double right = east * cos - north * sin;
    double measuredForward =
        (1.0 + p.softForward()) * forward
            + p.softCross() * right
            + p.hardForwardUt()
            + p.forwardUtPerA() * (field.leftA() + field.rightA())
            + p.noiseUt() * noise.nextGaussian();
    double measuredRight =
        (1.0 + p.softRight()) * right
            + p.softCross() * forward
            + p.hardRightUt()
            + p.rightUtPerA() * (field.leftA() - field.rightA())
            + p.noiseUt() * noise.nextGaussian();
    double heading = StrictMath.atan2(-measuredRight, measuredForward);
    double positive = heading < 0.0 ? heading + TURN_RAD : heading;
    return positive < TURN_RAD ? positive : 0.0;
  }

  /**
   * What disturbs a compass besides the earth's field.
   *
   * @param eastUt field of something at this place, towards east [µT]
   * @param northUt towards north [µT]
   * @param leftA current of the left, or only, motor, driving forward positive [A]
   * @param rightA current of the right motor [A]
   */
  public record Disturbance(double eastUt, double northUt, double leftA, double rightA) {
    /** Nothing. */
    public static Disturbance none() {
      return new Disturbance(0.0, 0.0, 0.0, 0.0);
    }
  }
}
