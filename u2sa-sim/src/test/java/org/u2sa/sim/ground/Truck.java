package org.u2sa.sim.ground;

import org.u2sa.sim.world.Footprint;

/**
 * A 1:10 truck. Mass, inertia, axles, steering angle and rate are those of F1TENTH's simulator
 * (f1tenth_gym: m 3.74 kg, I 0.04712 kg m², lf 0.15875 m, lr 0.17145 m, h 0.074 m, 0.4189 rad, 3.2
 * rad/s); its cornering stiffness is the mean of front and rear (4.7, 5.5). Motor: Pololu 37D,
 * 30:1, 12 V; battery: 3S lithium-polymer, 5 A h.
 */
public final class Truck {
  private Truck() {}

  public static AckermannParameters with(Payload payload) {
    return new AckermannParameters(
        3.74,
        0.04712,
        0.17145,
        0.074,
        0.3302,
        0.055,
        0.0005,
        0.4189,
        0.05,
        3.2,
        new MotorParameters(12.0, 330.0 * Math.PI / 30.0, 0.2, 14.0 * 0.0980665, 5.5, 0.0009, 0.04),
        new TyreParameters(5.0, 0.028, 0.01, 0.012),
        new BatteryParameters(12.6, 10.5, 0.03, 5.0, 0.3),
        payload);
  }

  /** At the origin, facing north, on a lawn. */
  public static AckermannVehicle vehicle(AckermannParameters p) {
    return new AckermannVehicle(
        p,
        GroundStart.atOrigin(),
        Footprint.rectangle(
            1.25 * p.wheelbaseM(),
            0.25 * p.wheelbaseM(),
            0.85 * p.wheelbaseM(),
            0.0,
            2.0 * p.cogHeightM()));
  }

  public static AckermannVehicle vehicle() {
    return vehicle(with(Payload.none()));
  }
}
