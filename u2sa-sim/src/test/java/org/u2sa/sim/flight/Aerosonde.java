package org.u2sa.sim.flight;

import java.util.List;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.WingCoefficients.Lateral;
import org.u2sa.sim.flight.WingCoefficients.Longitudinal;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * The Aerosonde with the parameters by which mavsim's published checks were computed: Beard and
 * McLain's, C_Dp 0.
 */
final class Aerosonde {
  static final double DENSITY = 1.2682;
  static final double STANDS_M = 0.3;
  static final MassProperties MASS =
      new MassProperties(11.0, Point.of(0.8244, 1.135, 1.759), 0.1204);
  static final World FIELD = World.at(new Geodetic(9.0, 54.0, 0.0));

  private Aerosonde() {}

  static WingCoefficients wing() {
    return new WingCoefficients(
        0.55,
        2.8956,
        0.18994,
        0.9,
        0.47,
        50.0,
        new Longitudinal(0.23, 5.61, 7.95, 0.13),
        0.0,
        0.0,
        0.0135,
        new Longitudinal(0.0135, -2.74, -38.21, -0.99),
        new Lateral(0.0, -0.98, 0.0, 0.0, 0.075, 0.19),
        new Lateral(0.0, -0.13, -0.51, 0.25, 0.17, 0.0024),
        new Lateral(0.0, 0.073, 0.069, -0.095, -0.011, -0.069));
  }

  static List<ControlSurface> surfaces() {
    return List.of(
        new ControlSurface("ELEVATOR", 0.5, 0.05, 1.0, 0.0, 0.0),
        new ControlSurface("AILERON", 0.5, 0.05, 0.0, 1.0, 0.0),
        new ControlSurface("RUDDER", 0.5, 0.05, 0.0, 0.0, 1.0));
  }

  static ElectricPropeller propeller() {
    double volt = 60.0 / (2.0 * Math.PI * 145.0);
    return new ElectricPropeller(
        "THROTTLE",
        20.0 * 0.0254,
        new ElectricPropeller.Quadratic(0.09357, -0.06044, -0.1079),
        new ElectricPropeller.Quadratic(0.005230, 0.004970, -0.01664),
        volt,
        0.042,
        1.5,
        3.7 * 12,
        0.1);
  }

  static UnmannedAircraft at(World world, double upM) {
    return UnmannedAircraft.fixedWing(
        MASS,
        wing(),
        surfaces(),
        propeller(),
        List.of(leg(0.5, 0.0), leg(-0.2, 0.4), leg(-0.2, -0.4)),
        Footprint.rectangle(0.8, 1.2, 2.9, -STANDS_M, 0.3),
        world,
        Point.of(0.0, 0.0, upM),
        0.0);
  }

  private static LandingLeg leg(double x, double y) {
    return LandingLeg.straight(Point.of(x, y, STANDS_M), true);
  }

  /** Deflections [rad] and throttle 0…1. */
  static void command(
      UnmannedAircraft aircraft, double elevator, double aileron, double rudder, double throttle) {
    aircraft.command("ELEVATOR", elevator / 0.5);
    aircraft.command("AILERON", aileron / 0.5);
    aircraft.command("RUDDER", rudder / 0.5);
    aircraft.command("THROTTLE", throttle);
  }
}
