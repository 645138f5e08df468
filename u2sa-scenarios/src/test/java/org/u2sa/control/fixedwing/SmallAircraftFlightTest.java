package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.ControlSurface;
import org.u2sa.sim.flight.ElectricPropeller;
import org.u2sa.sim.flight.MassProperties;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.flight.WingCoefficients;
import org.u2sa.sim.flight.WingCoefficients.Lateral;
import org.u2sa.sim.flight.WingCoefficients.Longitudinal;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** Small fixed-wing aircraft by CessnaControl, scored against the truth. */
class SmallAircraftFlightTest {
  private static final List<Point> ROUND =
      List.of(
          Point.of(0.0, 300.0, 60.0),
          Point.of(300.0, 300.0, 80.0),
          Point.of(300.0, -200.0, 60.0),
          Point.of(-100.0, -200.0, 50.0));

  static UnmannedAircraft aerosonde(World world) {
    double volt = 60.0 / (2.0 * Math.PI * 145.0);
    return UnmannedAircraft.fixedWing(
        new MassProperties(11.0, Point.of(0.8244, 1.135, 1.759), 0.1204),
        new WingCoefficients(
            0.55,
            2.8956,
            0.18994,
            0.9,
            0.47,
            50.0,
            new Longitudinal(0.23, 5.61, 7.95, 0.13),
            0.043,
            0.0,
            0.0135,
            new Longitudinal(0.0135, -2.74, -38.21, -0.99),
            new Lateral(0.0, -0.98, 0.0, 0.0, 0.075, 0.19),
            new Lateral(0.0, -0.13, -0.51, 0.25, 0.17, 0.0024),
            new Lateral(0.0, 0.073, 0.069, -0.095, -0.011, -0.069)),
        List.of(
            new ControlSurface("ELEVATOR", 0.4, 0.05, 1.0, 0.0, 0.0),
            new ControlSurface("AILERON", 0.4, 0.05, 0.0, 1.0, 0.0),
            new ControlSurface("RUDDER", 0.4, 0.05, 0.0, 0.0, 1.0)),
        new ElectricPropeller(
            "THROTTLE",
            20.0 * 0.0254,
            new ElectricPropeller.Quadratic(0.09357, -0.06044, -0.1079),
            new ElectricPropeller.Quadratic(0.005230, 0.004970, -0.01664),
            volt,
            0.042,
            1.5,
            3.7 * 12,
            0.1),
        List.of(),
        Footprint.rectangle(0.8, 1.2, 2.9, -0.3, 0.3),
        world,
        Point.of(0.0, 0.0, 1.5),
        0.0);
  }

  @ParameterizedTest
  @CsvSource({"0.0, 0.0, 1", "5.0, 1.0, 2", "8.0, -2.0, 3"})
  void fly_fromTheCatapultAroundFourPoints_passesEach(double windMps, double fromRad, long seed) {
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(Wind.gusty(fromRad, windMps, seed));
    UnmannedAircraft aircraft = aerosonde(world);
    aircraft.launch(new Catapult(22.0, Math.toRadians(10.0), 1.5, 2.0));
    try (SmallAircraftFlight flight =
        new SmallAircraftFlight(aircraft, Set.of("RUDDER"), SmallAircraftFlight.aerosonde())) {
      for (Point place : ROUND) {
        assertThat(flight.flyTo(place, 15.2, 90.0)).as("reaches %s", place).isTrue();
      }

      assertThat(aircraft.isAground()).isFalse();
    }
  }

  /**
   * The Zagi of Beard and McLain, Small Unmanned Aircraft, appendix E.1, with a fin: with their
   * C_nβ of −0.0004 nothing but a rudder would keep it straight. The motor is a small outrunner.
   */
  private static UnmannedAircraft zagi(World world) {
    return UnmannedAircraft.fixedWing(
        new MassProperties(1.56, Point.of(0.1147, 0.0576, 0.1712), 0.0015),
        new WingCoefficients(
            0.2589,
            1.4224,
            0.3302,
            0.9,
            0.4712,
            50.0,
            new Longitudinal(0.09167, 3.5016, 2.8932, 0.2724),
            0.0254,
            0.0,
            0.0,
            new Longitudinal(-0.02338, -0.5675, -1.3990, -0.3254),
            new Lateral(0.0, -0.07359, 0.0, 0.0, 0.0, 0.0),
            new Lateral(0.0, -0.02854, -0.3209, 0.03066, 0.1682, 0.0),
            new Lateral(0.0, 0.02, -0.01297, -0.00434, -0.00328, 0.0)),
        List.of(
            new ControlSurface("LEFT ELEVON", 0.5, 0.05, 0.5, 0.5, 0.0),
            new ControlSurface("RIGHT ELEVON", 0.5, 0.05, 0.5, -0.5, 0.0)),
        new ElectricPropeller(
            "THROTTLE",
            0.23,
            new ElectricPropeller.Quadratic(0.11, -0.05, -0.10),
            new ElectricPropeller.Quadratic(0.006, 0.004, -0.015),
            60.0 / (2.0 * Math.PI * 1_100.0),
            0.06,
            0.8,
            11.1,
            0.1),
        List.of(),
        Footprint.rectangle(0.3, 0.3, 1.4, -0.1, 0.1),
        world,
        Point.of(0.0, 0.0, 1.8),
        0.0);
  }

  private static Map<String, Object> zagiTuning() {
    Map<String, Object> tuning = SmallAircraftFlight.aerosonde();
    tuning.put("ELEVONS", true);
    tuning.put("CRUISE SPEED", 15.0);
    tuning.put("MAX SPEED", 22.0);
    tuning.put("REFERENCE SPEED", 15.0);
    tuning.put("STALL SPEED", 9.0);
    tuning.put("MIN LOOK AHEAD", 40.0);
    tuning.put("MIN SPEED", 6.0);
    tuning.put("THROTTLE TRIM", 0.5);
    return tuning;
  }

  @ParameterizedTest
  @CsvSource({"0.0, 0.0, 1", "4.0, 1.0, 2"})
  void fly_flyingWingThrownByHand_passesEach(double windMps, double fromRad, long seed) {
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(Wind.gusty(fromRad, windMps, seed));
    UnmannedAircraft aircraft = zagi(world);
    aircraft.launch(new Catapult(13.0, Math.toRadians(15.0), 1.5, 2.0));
    try (SmallAircraftFlight flight = new SmallAircraftFlight(aircraft, Set.of(), zagiTuning())) {
      for (Point place : ROUND) {
        assertThat(flight.flyTo(place, 15.2, 90.0)).as("reaches %s", place).isTrue();
      }

      assertThat(aircraft.isAground()).isFalse();
    }
  }
}
