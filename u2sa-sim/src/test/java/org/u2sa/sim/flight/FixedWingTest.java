package org.u2sa.sim.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.vehicle.BodyState;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * Against the published results of mavsim's checks (github.com/byu-magicc/mavsim_public,
 * mavsim_python/launch_files, chapters 3 to 5), and flights.
 */
class FixedWingTest {
  private static final double MAVSIM_GRAVITY = 9.81;

  // mavsim's order: position, velocity, quaternion, rates; of ours: position, quaternion, velocity
  private static double[] state(double[] mavsim, double... inputs) {
    double[] s = new double[BodyState.SIZE + inputs.length];
    System.arraycopy(mavsim, 0, s, BodyState.NED, 3);
    System.arraycopy(mavsim, 3, s, BodyState.VELOCITY, 3);
    System.arraycopy(mavsim, 6, s, BodyState.QUATERNION, 4);
    System.arraycopy(mavsim, 10, s, BodyState.RATES, 3);
    System.arraycopy(inputs, 0, s, FreeBody.ACTUATORS, inputs.length);
    return s;
  }

  private static double[] mavsim(double[] rate) {
    double[] m = new double[13];
    System.arraycopy(rate, BodyState.NED, m, 0, 3);
    System.arraycopy(rate, BodyState.VELOCITY, m, 3, 3);
    System.arraycopy(rate, BodyState.QUATERNION, m, 6, 4);
    System.arraycopy(rate, BodyState.RATES, m, 10, 3);
    return m;
  }

  private static double[] derivatives(FreeBody body, double[] s) {
    double[] rate = new double[body.size()];
    body.air.densityKgPerM3 = Aerosonde.DENSITY;
    body.derivatives(s, rate);
    return mavsim(rate);
  }

  private static FreeBody aerosonde() {
    Wings wings =
        new Wings(Aerosonde.wing(), Aerosonde.surfaces(), Aerosonde.propeller(), List.of());
    return new FreeBody(Aerosonde.MASS, wings, List.of(), MAVSIM_GRAVITY);
  }

  private static void assertClose(double[] actual, double[] published, double tolerance) {
    for (int i = 0; i < published.length; i++) {
      assertThat(actual[i]).as("state %d", i).isCloseTo(published[i], within(tolerance));
    }
  }

  @Test
  void derivatives_givenForcesWhileTurning_areThePublished() {
    FreeBody body =
        new FreeBody(Aerosonde.MASS, new GivenLoads(10, 5, 0, 0, 14, 0), List.of(), 0.0);

    double[] actual =
        derivatives(body, state(new double[] {5, 2, -20, 5, 0, 0, 1, 0, 0, 0, 1, 0.5, 0}));

    assertClose(
        actual,
        new double[] {
          5,
          0,
          0,
          0.90909091,
          0.45454545,
          2.5,
          0,
          0.5,
          0.25,
          0,
          0.06073576,
          12.22872247,
          -0.08413156
        },
        1e-8);
  }

  @Test
  void derivatives_levelWithHalfThrottle_areThePublished() {
    double[] level = {0, 0, -100, 25, 0, 0, 1, 0, 0, 0, 0, 0, 0};

    double[] actual = derivatives(aerosonde(), state(level, -0.2, 0.0, 0.005, 0.5));

    assertClose(
        actual,
        new double[] {
          25,
          0,
          0,
          -1.1008833637278692,
          0.01882484375,
          5.767612500567343,
          0,
          0,
          0,
          0,
          0.6021690003674433,
          7.714919589234582,
          -0.08257466286924951
        },
        1e-9);
  }

  /**
   * As parked in wind from behind and abeam: linear derivatives turned it over its nose and wing.
   */
  @Test
  void derivatives_airFromBehindOrAbeam_hardlyTurnIt() {
    double[] behind = {0, 0, 0, -8, 0, 0, 1, 0, 0, 0, 0, 0, 0};
    double[] abeam = {0, 0, 0, 0, 8, 0, 1, 0, 0, 0, 0, 0, 0};

    double[] nose = derivatives(aerosonde(), state(behind, 0.0, 0.0, 0.0, 0.0));
    double[] wing = derivatives(aerosonde(), state(abeam, 0.0, 0.0, 0.0, 0.0));

    assertThat(Math.abs(nose[11])).as("pitch acceleration %f", nose[11]).isLessThan(1.0);
    assertThat(Math.abs(wing[10])).as("roll acceleration %f", wing[10]).isLessThan(6.0);
  }

  @Test
  void derivatives_climbingTurnInAGust_areThePublished() {
    double[] turning = {
      61.9506532,
      22.2940203,
      -110.837551,
      27.3465947,
      0.619628233,
      1.42257772,
      0.938688796,
      0.247421558,
      0.0656821468,
      0.230936730,
      0.00498772167,
      0.168736005,
      0.171797313
    };
    double[] s = state(turning, -0.15705144, 0.01788999, 0.01084654, 1.0);
    FreeBody body = aerosonde();
    BodyAttitude attitude = new BodyAttitude();
    attitude.set(s[3], s[4], s[5], s[6]);
    double gustU = -0.00165177;
    double gustV = -0.00475441;
    double gustW = -0.01717199;
    body.air.windN = attitude.north(gustU, gustV, gustW);
    body.air.windE = attitude.east(gustU, gustV, gustW);
    body.air.windD = attitude.down(gustU, gustV, gustW);

    double[] actual = derivatives(body, s);

    assertThat(body.air.speedMps()).isCloseTo(27.39323489287441, within(1e-6));
    assertClose(
        actual,
        new double[] {
          24.283238643486627, 12.605130052025968, 1.2957327060769266, 3.1598677190678917,
          -0.28725560913165094, 1.0301313371736245, -0.025995661302161892, -0.011500703223228347,
          0.05851804333262313, 0.10134276693843723, 0.10284849278240359, 0.11393277483867911,
          -0.04899299126408019
        },
        1e-3); // mavsim divides the sideslip by the speed in the plane of symmetry
  }

  @Test
  void derivatives_publishedTrim_isSteady() {
    double[] trim = {0, 0, -100, 24.968743, 0, 1.249755, 0.999687, 0, 0.025003, 0, 0, 0, 0};

    double[] actual =
        derivatives(aerosonde(), state(trim, -0.124778, 0.001836, -0.000303, 0.676752));

    for (int i = 2; i < actual.length; i++) {
      assertThat(actual[i]).as("state %d", i).isCloseTo(0.0, within(0.015));
    }
  }

  @Test
  void launch_wingsHeldLevelAtFullThrottle_climbsAway() {
    UnmannedAircraft aircraft = Aerosonde.at(Aerosonde.FIELD, 1.5);
    aircraft.launch(new Catapult(18.0, Math.toRadians(10.0), 1.5, 2.0));

    for (int i = 0; i < 400; i++) {
      double roll = Math.IEEEremainder(aircraft.truth().attitude().phi(), 2.0 * Math.PI);
      Aerosonde.command(aircraft, -0.17, -0.3 * roll, 0.0, 1.0);
      aircraft.step(0.02);
    }

    assertThat(aircraft.isAground()).isFalse();
    assertThat(aircraft.truth().position().z()).isGreaterThan(10.0);
    assertThat(aircraft.truth().speedMps()).isBetween(12.0, 45.0);
  }

  @Test
  void step_fullThrottleOnWheels_takesOff() {
    UnmannedAircraft aircraft = Aerosonde.at(Aerosonde.FIELD, Aerosonde.STANDS_M);
    aircraft.step(1.0);
    Point stood = aircraft.truth().position();
    Aerosonde.command(aircraft, -0.1, 0.0, 0.0, 1.0);

    boolean rolled = false;
    for (int i = 0; i < 100 && aircraft.truth().position().z() < 3.0; i++) {
      aircraft.step(0.1);
      rolled |= aircraft.stands() && aircraft.truth().speedMps() > 8.0;
    }

    assertThat(stood.distance()).isLessThan(0.5);
    assertThat(rolled).isTrue();
    assertThat(aircraft.isAground()).isFalse();
    assertThat(aircraft.truth().position().z()).isGreaterThan(3.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 180.0})
  void step_rollingUpOrDownASlope_followsItAndFeelsItsWeight(double uphillDeg) {
    World sloping = Aerosonde.FIELD.with(Terrain.slope(0.05, Math.toRadians(uphillDeg)));
    UnmannedAircraft aircraft = Aerosonde.at(sloping, Aerosonde.STANDS_M);
    aircraft.step(1.0);
    aircraft.fly(new Attitude(0.0, 0.0, 0.0), Point.of(10.0, 0.0, 0.0));
    aircraft.step(0.5);

    for (int i = 0; i < 400; i++) {
      aircraft.step(0.0025);
      VehicleTruth truth = aircraft.truth();
      Point at = truth.position();
      double ground = sloping.terrain().heightM(at.x(), at.y());
      assertThat(at.z() - ground).isCloseTo(Aerosonde.STANDS_M, within(0.02));
      assertThat(truth.specificForce().z()).isCloseTo(-Gravity.STANDARD_MPS2, within(1.0));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void step_gustsWithASeed_repeatToTheLastBit(long seed) {
    World gusty = World.at(new Geodetic(9.0, 54.0, 0.0)).with(Wind.gusty(1.0, 6.0, seed));

    VehicleTruth one = flown(gusty);
    VehicleTruth other = flown(gusty);
    VehicleTruth calm = flown(Aerosonde.FIELD);

    assertThat(one).isEqualTo(other);
    assertThat(one).isNotEqualTo(calm);
  }

  private static VehicleTruth flown(World world) {
    UnmannedAircraft aircraft = Aerosonde.at(world, 100.0);
    aircraft.launch(new Catapult(25.0, 0.05, 1.5, 2.0));
    Aerosonde.command(aircraft, -0.124778, 0.001836, -0.000303, 0.676752);
    aircraft.step(5.0);
    return aircraft.truth();
  }

  @Test
  void liftAt_beyondTheStall_isAFlatPlates() {
    WingCoefficients wing = Aerosonde.wing();

    assertThat(wing.liftAt(0.3)).isCloseTo(0.23 + 5.61 * 0.3, within(0.01));
    assertThat(wing.liftAt(0.6))
        .isCloseTo(2.0 * Math.pow(Math.sin(0.6), 2) * Math.cos(0.6), within(0.01));
    assertThat(wing.liftAt(-0.6)).isCloseTo(-wing.liftAt(0.6), within(0.01));
    assertThat(wing.dragAt(Math.PI / 2.0)).isCloseTo(2.0, within(0.01));
    for (double alpha = -Math.PI; alpha <= Math.PI; alpha += 0.01) {
      assertThat(wing.liftAt(alpha)).isBetween(-3.0, 3.0);
      assertThat(wing.dragAt(alpha)).isBetween(0.0, 2.1);
    }
  }

  /** Loads that depend on nothing. */
  private static final class GivenLoads implements AirLoads {
    private final double[] values;

    GivenLoads(double... values) {
      this.values = values;
    }

    @Override
    public List<String> actuators() {
      return List.of();
    }

    @Override
    public void command(int actuator, double value) {
      throw new IllegalStateException("has no actuators");
    }

    @Override
    public void weaken(int actuator, double share) {
      throw new IllegalStateException("has no actuators");
    }

    @Override
    public boolean isDriven() {
      return false;
    }

    @Override
    public double spanM() {
      return 1.0;
    }

    @Override
    public double powerW(double[] s, int first, Air air) {
      return 0.0;
    }

    @Override
    public void add(double[] s, double[] rate, int first, Air air, double[] load) {
      System.arraycopy(values, 0, load, 0, values.length);
    }
  }
}
