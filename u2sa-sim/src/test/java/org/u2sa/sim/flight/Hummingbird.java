package org.u2sa.sim.flight;

import java.util.List;
import java.util.stream.IntStream;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** The AscTec Hummingbird with rotorpy's parameters, and a hexacopter of the same parts. */
final class Hummingbird {
  static final double MASS_KG = 0.5;
  static final double MAX_RADPS = 1_500.0;
  static final double ARM_M = 0.17;
  static final double STANDS_M = 0.1;
  static final World FIELD = World.at(new Geodetic(9.0, 54.0, 0.0));

  private static final double HALF = Math.sqrt(0.5);
  private static final MassProperties MASS =
      new MassProperties(MASS_KG, Point.of(3.65e-3, 3.68e-3, 7.03e-3), 0.0);
  private static final Point FRAME_DRAG = Point.of(0.5e-2, 0.5e-2, 1e-2);

  private Hummingbird() {}

  static UnmannedAircraft quad(World world, double upM) {
    List<Rotor> rotors =
        List.of(
            rotor(1, HALF, -HALF, 1),
            rotor(2, HALF, HALF, -1),
            rotor(3, -HALF, HALF, 1),
            rotor(4, -HALF, -HALF, -1));
    return build(MASS, rotors, world, upM);
  }

  static UnmannedAircraft hexa(World world, double upM) {
    List<Rotor> rotors =
        IntStream.range(0, 6)
            .mapToObj(
                i ->
                    rotor(
                        i + 1,
                        Math.cos(Math.toRadians(60.0 * i)),
                        Math.sin(Math.toRadians(60.0 * i)),
                        i % 2 == 0 ? 1 : -1))
            .toList();
    return build(MASS, rotors, world, upM);
  }

  private static UnmannedAircraft build(
      MassProperties mass, List<Rotor> rotors, World world, double upM) {
    return UnmannedAircraft.multirotor(
        mass,
        rotors,
        FRAME_DRAG,
        List.of(leg(0.1, 0.1), leg(0.1, -0.1), leg(-0.1, 0.1), leg(-0.1, -0.1)),
        Footprint.rectangle(0.2, 0.2, 0.4, -STANDS_M, 0.1),
        world,
        Point.of(0.0, 0.0, upM),
        0.0);
  }

  private static LandingLeg leg(double x, double y) {
    return LandingLeg.straight(Point.of(x, y, STANDS_M), false);
  }

  private static Rotor rotor(int number, double x, double y, int spin) {
    return new Rotor(
        "ROTOR " + number,
        Point.of(ARM_M * x, ARM_M * y, 0.0),
        Point.of(0.0, 0.0, -1.0),
        spin,
        5.57e-6,
        1.36e-7,
        1.19e-4,
        2.32e-4,
        3.39e-3,
        MAX_RADPS,
        0.005);
  }

  static void command(UnmannedAircraft aircraft, double... radPerS) {
    for (int i = 0; i < radPerS.length; i++) {
      aircraft.command("ROTOR " + (i + 1), radPerS[i] / MAX_RADPS);
    }
  }
}
