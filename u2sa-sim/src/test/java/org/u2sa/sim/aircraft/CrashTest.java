package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

class CrashTest {
  private static final ControlInputs HANDS_OFF = ControlInputs.neutral();

  @Test
  void step_droppedFromAHand_bouncesAndStands() {
    Cessna172 aircraft = above(0.3, 0.0, 0.0, 0.0);
    aircraft.step(HANDS_OFF.withBrakes(1.0, 1.0), 10.0);
    assertThat(aircraft.state().crashed()).isFalse();
    assertThat(aircraft.state().heightAboveGroundM()).isBetween(-0.02, 0.02);
  }

  @Test
  void step_droppedFromARoof_crashes() {
    Cessna172 aircraft = above(3.0, 0.0, 0.0, 0.0);
    aircraft.step(HANDS_OFF, 3.0);
    assertThat(aircraft.state().crashed()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({"35.0, 0.0", "-35.0, 0.0", "0.0, 20.0", "0.0, -20.0", "180.0, 0.0"})
  void step_touchingWithAnythingButWheels_crashes(double rollDeg, double pitchDeg) {
    Cessna172 aircraft = above(1.6, 25.0, Math.toRadians(rollDeg), Math.toRadians(pitchDeg));
    for (int i = 0; i < 240 && !aircraft.state().crashed(); i++) {
      aircraft.step(HANDS_OFF, 1.0 / 120.0);
    }
    assertThat(aircraft.state().crashed()).isTrue();
  }

  @Test
  void step_intoTheGround_crashesAndStaysForEver() {
    Cessna172 aircraft = above(100.0, 55.0, 0.0, -0.5);
    aircraft.step(HANDS_OFF.withThrottle(1.0).withSurfaces(0.0, 0.5, 0.0), 30.0);
    AircraftMotion wreck = aircraft.state();
    assertThat(wreck.crashed()).isTrue();
    assertThat(wreck.trueAirspeedMps()).isZero();
    assertThat(wreck.engineRpm()).isZero();
    aircraft.startEngine();
    aircraft.step(HANDS_OFF.withThrottle(1.0).withSurfaces(1.0, -1.0, 1.0), 10.0);
    AircraftMotion later = aircraft.state();
    assertThat(later.timeS()).isEqualTo(wreck.timeS() + 10.0);
    assertThat(later).usingRecursiveComparison().ignoringFields("timeS").isEqualTo(wreck);
  }

  @Test
  void step_gentleFlare_landsAndIsWhole() {
    Cessna172 aircraft = above(0.5, 30.0, 0.0, 0.12);
    for (int i = 0; i < 400; i++) {
      AircraftMotion state = aircraft.state();
      double wanted = state.weightOnWheels() ? 0.04 : 0.12;
      aircraft.step(HandPilot.hold(state, HANDS_OFF, wanted, 0.0, -0.15), 0.025);
    }
    assertThat(aircraft.state().crashed()).isFalse();
    assertThat(aircraft.state().weightOnWheels()).isTrue();
  }

  @Test
  void step_terrainRises_crashesIntoTheHill() {
    Trim trim = Trim.level(300.0, 50.0, 0.0);
    World cliff = World.at(new Geodetic(0.0, 0.0, 0.0)).with(new Cliff(1_105.0, 320.0));
    Cessna172 aircraft = Cessna172.inFlight(trim.start(0, 0, 0, 0), cliff);
    aircraft.step(trim.controls(), 15.0);
    assertThat(aircraft.state().crashed()).isFalse();
    aircraft.step(trim.controls(), 15.0);
    assertThat(aircraft.state().crashed()).isTrue();
  }

  @Test
  void new_terrainWithoutElevation_isRefusedWithThePlace() {
    assertThatIllegalStateException()
        .isThrownBy(
            () ->
                Cessna172.onRunway(
                    new RunwayStart(8.0, 50.0, 0.0, 0.0),
                    World.at(new Geodetic(8.0, 50.0, 0.0)).with(new Cliff(-1.0, Double.NaN)),
                    true))
        .withMessageContaining("NaN is not a number of metres");
  }

  /** Ground that is as high as this from a line northward. */
  private record Cliff(double fromNorthM, double high) implements Terrain {
    @Override
    public double heightM(double eastM, double northM) {
      return northM > fromNorthM ? high : 0.0;
    }

    @Override
    public double riseEast(double eastM, double northM) {
      return 0.0;
    }

    @Override
    public double riseNorth(double eastM, double northM) {
      return 0.0;
    }

    @Override
    public double steepest() {
      return Double.POSITIVE_INFINITY;
    }

    @Override
    public double highestM() {
      return high;
    }
  }

  /** The wheels this far above ground, flying north without climb. */
  private static Cessna172 above(double heightM, double speedMps, double roll, double pitch) {
    FlightStart start =
        new FlightStart(
            0.0,
            0.0,
            LandingGear.STANDING_M + heightM,
            0.0,
            0.0,
            speedMps,
            Math.cos(roll) * pitch,
            0.0,
            roll,
            pitch,
            PistonEngine.IDLE_RPM,
            0.0);
    return Cessna172.inFlight(start, Wind.calm());
  }
}
