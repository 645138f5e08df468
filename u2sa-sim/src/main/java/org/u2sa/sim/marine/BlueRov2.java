package org.u2sa.sim.marine;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * The BlueROV2 with six T200 thrusters: four vectored in the plane, two vertical.
 *
 * <p>Masses and drag after Wu: 6-DoF Modelling and Control of a Remotely Operated Vehicle (master's
 * thesis, Flinders University, 2018), widely used since; thrust of the T200 at 14 V, rounded.
 * Slightly positive buoyancy makes it rise when idle.
 */
public final class BlueRov2 {
  /** Thrust of one thruster at full command [N]. */
  public static final double FORWARD_N = 40.0;

  /** Thrust of one thruster at full astern command [N]. */
  public static final double REVERSE_N = 30.0;

  private static final double AHEAD_M = 0.156;
  private static final double ASIDE_M = 0.111;
  private static final double HALF = StrictMath.sqrt(0.5);
  private static final double DEADBAND = 0.04;
  private static final double EXPONENT = 2.0;
  private static final double LAG_S = 0.1;

  private BlueRov2() {}

  /** Hull parameters. */
  public static Hull hull() {
    return new Hull(
        11.5,
        Point.of(0.16, 0.16, 0.16),
        Point.of(5.5, 12.7, 14.57),
        Point.of(0.12, 0.12, 0.12),
        Point.of(4.03, 6.22, 5.18),
        Point.of(0.07, 0.07, 0.07),
        Point.of(18.18, 21.66, 36.99),
        Point.of(1.55, 1.55, 1.55),
        Point.of(0.0, 0.0, 0.02),
        Point.ORIGIN,
        114.8,
        0.25,
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Point.ORIGIN,
        true);
  }

  /** Thrusters THRUSTER 1…6: front right and left, rear right and left, vertical right and left. */
  public static List<VesselThruster> thrusters() {
    return List.of(
        thruster(1, Point.of(AHEAD_M, ASIDE_M, 0.0), Point.of(HALF, -HALF, 0.0)),
        thruster(2, Point.of(AHEAD_M, -ASIDE_M, 0.0), Point.of(HALF, HALF, 0.0)),
        thruster(3, Point.of(-AHEAD_M, ASIDE_M, 0.0), Point.of(HALF, HALF, 0.0)),
        thruster(4, Point.of(-AHEAD_M, -ASIDE_M, 0.0), Point.of(HALF, -HALF, 0.0)),
        thruster(5, Point.of(0.0, ASIDE_M, 0.0), Point.of(0.0, 0.0, 1.0)),
        thruster(6, Point.of(0.0, -ASIDE_M, 0.0), Point.of(0.0, 0.0, 1.0)));
  }

  private static VesselThruster thruster(int number, Point place, Point direction) {
    return new VesselThruster(
        "THRUSTER " + number,
        place,
        direction,
        FORWARD_N,
        REVERSE_N,
        DEADBAND,
        EXPONENT,
        LAG_S,
        0.0);
  }

  /**
   * Creates a vehicle at rest.
   *
   * @param world with water
   * @param start east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public static Vessel at(World world, Point start, double headingRad) {
    Footprint footprint = Footprint.rectangle(0.23, 0.23, 0.34, -0.125, 0.125);
    return new Vessel(hull(), thrusters(), footprint, world, start, headingRad);
  }
}
