package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.Repository;
import org.u2sa.testkit.ServiceKit;

/** How far the estimate is off 60 s after the last fix, by what measures wind and water. */
class DriftWithoutGpsTest {
  private static final double STEP_S = 0.05;
  private static final double FIXES_S = 120.0;
  private static final double OUTAGE_S = 60.0;
  private static final double LEG_S = 30.0;
  private static final int SEEDS = 3;

  private static final Map<String, Object> WATER = Map.of("FLUID SENSORS", "Log");
  private static final Map<String, Object> WATER_AND_WIND =
      Map.of(
          "FLUID SENSORS", "Log",
          "SAIL AREA", 0.5,
          "DISPLACEMENT", 60.0,
          "SWAY DRAG", 40.0,
          "SWAY SQUARE DRAG", 90.0);

  /** Error of the position after the outage [m], root mean square over the seeds. */
  private static double errorM(Map<String, Object> variables) {
    double sum = 0.0;
    for (long seed = 1; seed <= SEEDS; seed++) {
      double error = sail(seed, variables);
      sum += error * error;
    }
    return Math.sqrt(sum / SEEDS);
  }

  private static double sail(long seed, Map<String, Object> variables) {
    Random random = new Random(seed);
    double from = 2.0 * Math.PI * random.nextDouble();
    double towards = 2.0 * Math.PI * random.nextDouble();
    World world =
        World.at(new Geodetic(-82.45, 27.37, 0.0))
            .with(Wind.gusty(from, 6.0, seed))
            .with(new Water(0.0, 0.4 * Math.sin(towards), 0.4 * Math.cos(towards)));
    SimulatedVehicle boat =
        VehicleFile.load(Repository.root().resolve("config/roboboat/vehicle.xml"))
            .make(world, Point.ORIGIN, 0.0, seed);
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("DOMAIN", "WATER")
          .with("LOST SIGMA", 1000.0)
          .with("POSITION CORRELATION", 60.0)
          .with("FLOW SIGMA", 0.5);
      variables.forEach(kit::with);
      kit.start(FusingStateEstimator::new);
      Sensors sensors = new Sensors(random, boat);
      double first = 2.0 * Math.PI * random.nextDouble();
      for (int i = 0; i * STEP_S < FIXES_S + OUTAGE_S; i++) {
        double timeS = i * STEP_S;
        steer(boat, first + Math.PI / 2.0 * Math.floor(timeS / LEG_S));
        boat.step(STEP_S);
        kit.advance(STEP_S);
        sensors.publish(kit, i, timeS < FIXES_S);
      }
      StateInformation state = kit.latest(Channels.STATE).orElseThrow();
      Point truth = boat.truth().position();
      return world
          .plane()
          .at(truth.x(), truth.y(), 0.0)
          .distanceM(new Geodetic(state.x().orElseThrow(), state.y().orElseThrow(), 0.0));
    }
  }

  private static void steer(SimulatedVehicle boat, double headingRad) {
    VehicleTruth now = boat.truth();
    double off = Math.IEEEremainder(headingRad - now.headingRad(), 2.0 * Math.PI);
    double turn = Math.max(-0.15, Math.min(0.15, 0.3 * off - 0.3 * now.rates().z()));
    boat.command("LEFT THRUSTER", 0.25 + turn);
    boat.command("RIGHT THRUSTER", 0.25 - turn);
  }

  /** Noise of a phone's inertial sensors, a good receiver, and the usual instruments. */
  private record Sensors(Random random, SimulatedVehicle boat) {
    private double noisy(double exact, double sigma) {
      return exact + sigma * random.nextGaussian();
    }

    void publish(ServiceKit kit, int step, boolean hasFix) {
      VehicleTruth truth = boat.truth();
      Point force = truth.specificForce();
      InertialMeasurement imu = new InertialMeasurement();
      imu.sensorName("Imu").referenceFrame(ReferenceFrame.BODY_FRD);
      imu.rollRate(noisy(truth.rates().x(), 0.005)).pitchRate(noisy(truth.rates().y(), 0.005));
      imu.yawRate(noisy(truth.rates().z(), 0.005));
      imu.specificForceX(noisy(force.x() + 0.05, 0.05));
      imu.specificForceY(noisy(force.y() - 0.05, 0.05));
      imu.specificForceZ(noisy(force.z(), 0.05)).specificForceSigma(0.05).angularRateSigma(0.005);
      kit.publish(Channels.SENSED_STATE, imu);
      StateInformation compass = new StateInformation().sensorName("Compass");
      kit.publish(
          Channels.SENSED_STATE, compass.psi(noisy(truth.headingRad(), 0.01)).psiSigma(0.01));
      if (step % 4 != 0) {
        return;
      }
      Point air = truth.velocity().minus(boat.air());
      Point water = truth.velocity().minus(current());
      StateInformation wind = new StateInformation().sensorName("WindSensor");
      wind.referenceFrame(ReferenceFrame.BODY);
      wind.fluidxDot(noisy(ahead(air), 0.3)).fluidyDot(noisy(left(air), 0.3));
      kit.publish(Channels.SENSED_STATE, wind.fluidxDotSigma(0.3).fluidyDotSigma(0.3));
      StateInformation log = new StateInformation().sensorName("Log");
      log.referenceFrame(ReferenceFrame.BODY).fluidxDot(noisy(ahead(water), 0.05));
      kit.publish(Channels.SENSED_STATE, log.fluidxDotSigma(0.05));
      if (hasFix) {
        Geodetic at = boat.world().plane().at(truth.position().x(), truth.position().y(), 0.0);
        StateInformation fix = new StateInformation().sensorName("Gps");
        fix.x(at.longitudeDeg()).y(at.latitudeDeg()).z(0.0);
        kit.publish(Channels.SENSED_STATE, fix.xSigma(0.3).ySigma(0.3).zSigma(1.0));
      }
    }

    private Point current() {
      return boat.world().water().orElseThrow().currentAt(boat.truth().position());
    }

    private double ahead(Point enu) {
      double psi = boat.truth().headingRad();
      return enu.x() * Math.sin(psi) + enu.y() * Math.cos(psi);
    }

    private double left(Point enu) {
      double psi = boat.truth().headingRad();
      return -enu.x() * Math.cos(psi) + enu.y() * Math.sin(psi);
    }
  }

  @Test
  void sail_withoutFixesFor60Seconds_windMakesTheErrorSmaller() {
    double water = errorM(WATER);
    double both = errorM(WATER_AND_WIND);

    assertThat(water).isLessThan(10.0);
    assertThat(both).isLessThan(0.7 * water);
  }
}
