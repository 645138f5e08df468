package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Model of a magnetometer on a level vehicle and its heading: the earth's field plus local
 * disturbances, distorted by the vehicle's iron and motor currents.
 */
public final class CompassModel {
  private static final double TURN_RAD = 2.0 * Math.PI;

  private final CompassParameters p;
  private final Random noise;

  /** Uses the random stream {@code compass}. */
  public CompassModel(CompassParameters parameters, NoiseStreams streams) {
    this.p = parameters;
    this.noise = streams.of("compass");
  }

  /** Measured magnetic heading [rad, 0…2π) for a vehicle state and disturbance. */
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
   * Disturbances of a compass besides the earth's field.
   *
   * @param eastUt local magnetic disturbance, east [µT]
   * @param northUt local magnetic disturbance, north [µT]
   * @param leftA current of the left, or only, motor, driving forward positive [A]
   * @param rightA current of the right motor [A]
   */
  public record Disturbance(double eastUt, double northUt, double leftA, double rightA) {
    /** No disturbance. */
    public static Disturbance none() {
      return new Disturbance(0.0, 0.0, 0.0, 0.0);
    }
  }
}
