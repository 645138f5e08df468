package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.Trim;
import org.u2sa.sim.atmosphere.Wind;

class ThesisLawTest {
  private static final double FOOT_M = 0.3048;
  private static final double LON = -157.9;
  private static final double LAT = 21.2;
  private static final double DT_S = 0.1; // 4.5.2.1: FlightGear sent at 10 Hz

  private final ThesisControl.ThesisLaw law =
      new ThesisControl.ThesisLaw(
          XmlConfiguration.inMemory("none", Map.of())
              .settings(ThesisControl.ThesisLaw.Variables.class)
              .get());

  @Test
  void differential_isScaledBetween10And1000Feet() {
    assertThat(ThesisControl.ThesisLaw.differential(10.0 * FOOT_M)).isZero();
    assertThat(ThesisControl.ThesisLaw.differential(505.0 * FOOT_M)).isCloseTo(0.5, within(1e-9));
    assertThat(ThesisControl.ThesisLaw.differential(-2000.0 * FOOT_M)).isEqualTo(-1.0);
  }

  @Test
  void surfaces_pointToTheRightAndAbove_rollRightNoseUpMoreThrottle() {
    Surfaces surfaces =
        law.surfaces(
            States.level().pitch(Math.toRadians(6.0)).now(),
            new GuidanceTarget(-100.0, 300.0, 500.0, OptionalDouble.empty()));
    assertThat(surfaces.aileron()).isPositive();
    assertThat(surfaces.elevator()).isNegative();
    assertThat(surfaces.throttle()).isGreaterThan(0.6);
  }

  @Test
  void surfaces_calmAir_staysInTheAirAndPassesTheWaypoints() {
    Cessna172 aircraft =
        Cessna172.inFlight(
            Trim.level(500.0, 45.0, 0.0).start(LON, LAT, 0.0, Math.PI / 2.0), Wind.calm());
    double[][] waypoints = {{0, 4000, 500}, {3000, 6000, 600}, {6000, 3000, 600}, {3000, 0, 500}};
    int next = 0;
    double worstBank = 0.0;
    while (next < waypoints.length && aircraft.state().timeS() < 900.0) {
      AircraftMotion truth = aircraft.state();
      FlightState state = SimulatedFlight.see(truth, LON, LAT);
      double north = waypoints[next][0] - state.northM();
      double east = waypoints[next][1] - state.eastM();
      if (Math.hypot(north, east) < 250.0) {
        next++;
        continue;
      }
      Surfaces s =
          law.surfaces(
              state, new GuidanceTarget(north, east, waypoints[next][2], OptionalDouble.empty()));
      aircraft.step(
          new ControlInputs(s.aileron(), s.elevator(), s.rudder(), s.throttle(), 1.0, 0, 0, 0),
          DT_S);
      worstBank = Math.max(worstBank, Math.abs(state.rollRad()));
      assertThat(truth.crashed()).isFalse();
      assertThat(truth.stalled()).isFalse();
      assertThat(state.altitudeM()).isBetween(300.0, 800.0);
    }
    assertThat(next).isEqualTo(waypoints.length);
    assertThat(Math.toDegrees(worstBank)).isLessThan(40.0);
  }
}
