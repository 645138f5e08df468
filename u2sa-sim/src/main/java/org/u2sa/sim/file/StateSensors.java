package org.u2sa.sim.file;

import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedAnemometer;
import org.u2sa.sim.device.SimulatedBarometer;
import org.u2sa.sim.device.SimulatedCompass;
import org.u2sa.sim.device.SimulatedDepthGauge;
import org.u2sa.sim.device.SimulatedEncoder;
import org.u2sa.sim.device.SimulatedGps;
import org.u2sa.sim.device.SimulatedImu;
import org.u2sa.sim.device.SimulatedPitotTube;
import org.u2sa.sim.device.SimulatedVelocityLog;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/** Sensors of the vehicle's own state. */
final class StateSensors {
  private static final double UT = 200.0; // largest magnetic field [µT]

  private StateSensors() {}

  static GpsParameters gpsParameters(FileElement file) {
    return new GpsParameters(
        file.number("rate", "Hz", 0.1, 100.0),
        file.number("delay", "s", 0.0, 5.0),
        file.number("sigma", "m", 0.0, 100.0),
        file.number("bias", "m", 0.0, 100.0),
        file.positive("biasTime", "s", 1e6),
        file.number("verticalFactor", "1", 0.0, 10.0),
        file.number("velocitySigma", "m/s", 0.0, 10.0),
        file.number("betweenDropouts", "s", 0.0, 1e9, 0.0),
        file.positive("dropoutTime", "s", 1e6),
        file.count("satellites", 0, 99),
        file.count("quality", 1, 8));
  }

  static SensorKinds.Reader gps(FileElement file) {
    GpsParameters parameters = gpsParameters(file);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        Map.of("DELAY", parameters.latencyS()),
        mount.place(),
        vehicle ->
            new SimulatedGps(
                parameters,
                vehicle.world().plane(),
                vehicle.streams(),
                vehicle.at(mount),
                () -> isUnderWater(vehicle, mount)));
  }

  private static boolean isUnderWater(Aboard vehicle, Mount mount) {
    VehicleTruth antenna = vehicle.at(mount).get();
    return depthM(vehicle.world(), antenna) > 0.0;
  }

  /** Parameters as a function of the declination [rad]. */
  static DoubleFunction<CompassParameters> compassParameters(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 200.0);
    double field = file.number("field", "uT", 1.0, 60.0);
    List<Double> hard = pair(file, "hardIron", "uT", UT);
    List<Double> soft = file.numbers("softIron", "1", -0.9, 2.0, 3);
    List<Double> currents = pair(file, "motorField", "uT/A", 10.0);
    double sigma = file.number("sigma", "uT", 0.0, 50.0);
    if (soft.size() != 3) {
      throw file.xml().error("softIron: expected three numbers: forward, right, cross");
    }
    return declinationRad ->
        new CompassParameters(
            rate,
            declinationRad,
            field,
            hard.get(0),
            hard.get(1),
            soft.get(0),
            soft.get(1),
            soft.get(2),
            currents.get(0),
            currents.get(1),
            sigma);
  }

  static SensorKinds.Reader compass(FileElement file) {
    DoubleFunction<CompassParameters> parameters = compassParameters(file);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedCompass(
                parameters.apply(declinationRad(vehicle.world(), MagneticModel.FIRST_YEAR)),
                vehicle.streams(),
                vehicle.truth(),
                CompassModel.Disturbance::none));
  }

  private static List<Double> pair(FileElement file, String name, String unit, double most) {
    List<Double> two = file.numbers(name, unit, -most, most, 2);
    if (two.size() != 2) {
      throw file.xml().error(name + ": expected two numbers: forward, right");
    }
    return two;
  }

  static double declinationRad(World world, double year) {
    Geodetic origin = world.plane().origin();
    return MagneticModel.declinationRad(
        origin.latitudeDeg(), origin.longitudeDeg(), origin.altitudeM(), year);
  }

  static SensorKinds.Reader imu(FileElement file) {
    SimulatedImu.Errors errors =
        new SimulatedImu.Errors(
            file.number("rate", "Hz", 0.1, 10_000.0),
            file.number("attitudeSigma", "rad", 0.0, 1.0),
            file.number("headingSigma", "rad", 0.0, 1.0),
            file.number("rateSigma", "rad/s", 0.0, 10.0),
            file.number("rateBias", "rad/s", 0.0, 10.0),
            file.number("forceSigma", "m/s^2", 0.0, 100.0),
            file.number("forceBias", "m/s^2", 0.0, 100.0));
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        Map.of(),
        mount.place(),
        vehicle -> {
          Supplier<VehicleTruth> own = vehicle.at(mount);
          return new SimulatedImu(
              errors, vehicle.streams(), () -> SimulatedImu.readingOf(own.get()));
        });
  }

  static SensorKinds.Reader encoders(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 10_000.0);
    double counts = file.number("countsPerTurn", "1", 1.0, 1e7);
    double missed = file.number("missed", "1", 0.0, 1.0, 0.0);
    return new SensorKinds.Reader(
        Map.of("COUNTS PER TURN", counts),
        vehicle ->
            new SimulatedEncoder(
                rate,
                counts,
                missed,
                vehicle.streams(),
                () -> vehicle.wheels().get().leftWheelRad(),
                () -> vehicle.wheels().get().rightWheelRad()));
  }

  static SensorErrors errors(FileElement file, String unit) {
    return new SensorErrors(
        file.number("rate", "Hz", 0.1, 10_000.0),
        file.number("delay", "s", 0.0, 60.0),
        file.number("sigma", unit, 0.0, 1e6),
        file.number("bias", unit, 0.0, 1e6),
        file.number("dropouts", "1", 0.0, 1.0, 0.0));
  }

  static SensorKinds.Reader barometer(FileElement file) {
    SensorErrors errors = errors(file, "Pa");
    double qnh = file.number("qnh", "Pa", 85_000.0, 110_000.0, PressureAltitude.SEA_LEVEL_PA);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedBarometer(errors, qnh, vehicle.streams(), () -> vehicle.altitudeM(mount)));
  }

  static SensorKinds.Reader depthGauge(FileElement file) {
    SensorErrors errors = errors(file, "Pa");
    double density = file.number("density", "kg/m^3", 500.0, 2_000.0, 1_025.0);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        Map.of("WATER DENSITY", density, "MOUNTED Z", mount.place().z()),
        vehicle ->
            new SimulatedDepthGauge(
                errors,
                density,
                vehicle.streams(),
                () -> depthM(vehicle.world(), vehicle.at(mount).get())));
  }

  private static double depthM(World world, VehicleTruth sensor) {
    return world.water().map(water -> water.headM(sensor.position(), sensor.timeS())).orElse(0.0);
  }

  static SensorKinds.Reader pitotTube(FileElement file) {
    SensorErrors errors = errors(file, "Pa");
    double blockedAt = file.number("blockedAt", "s", 0.0, 1e9, Double.POSITIVE_INFINITY);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        vehicle ->
            new SimulatedPitotTube(
                errors,
                vehicle.streams(),
                vehicle.at(mount),
                vehicle.air(),
                () -> vehicle.altitudeM(mount),
                blockedAt));
  }

  static SensorKinds.Reader anemometer(FileElement file) {
    SensorErrors errors = errors(file, "m/s");
    double directionSigma = file.number("directionSigma", "rad", 0.0, 1.0);
    Mount mount = Mount.pose(file);
    return new SensorKinds.Reader(
        Map.of("MOUNTED YAW", -mount.turn().z()), // BODY: yaw is positive to the left
        vehicle ->
            new SimulatedAnemometer(
                errors, directionSigma, vehicle.streams(), vehicle.at(mount), vehicle.air()));
  }

  static SensorKinds.Reader velocityLog(FileElement file) {
    SensorErrors errors = errors(file, "m/s");
    double reach = file.positive("reach", "m", 10_000.0);
    Mount mount = Mount.place(file);
    return new SensorKinds.Reader(
        Map.of("DELAY", errors.latencyS()),
        mount.place(),
        vehicle ->
            new SimulatedVelocityLog(
                errors,
                reach,
                vehicle.streams(),
                vehicle.at(mount),
                () -> current(vehicle.world(), vehicle.at(mount).get()),
                () -> aboveGroundM(vehicle.world(), vehicle.at(mount).get())));
  }

  private static Point current(World world, VehicleTruth sensor) {
    return world.water().map(water -> water.currentAt(sensor.position())).orElse(Point.ORIGIN);
  }

  private static double aboveGroundM(World world, VehicleTruth sensor) {
    Point at = sensor.position();
    return at.z() - world.terrain().heightM(at.x(), at.y());
  }
}
