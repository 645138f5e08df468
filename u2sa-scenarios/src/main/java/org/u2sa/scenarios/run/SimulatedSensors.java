package org.u2sa.scenarios.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.device.AirspeedSensor;
import org.u2sa.device.BarometerSensor;
import org.u2sa.device.CompassSensor;
import org.u2sa.device.Devices;
import org.u2sa.device.GpsSensor;
import org.u2sa.device.ImuSensor;
import org.u2sa.device.PressureAltitude;
import org.u2sa.device.TrafficSensor;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedBarometer;
import org.u2sa.sim.device.SimulatedCompass;
import org.u2sa.sim.device.SimulatedGps;
import org.u2sa.sim.device.SimulatedImu;
import org.u2sa.sim.device.SimulatedPitotTube;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Provides simulated devices for all sensors of a demo's system file, so one line there adds an
 * IMU, a second receiver or a barometer. A service configured for a device other than {@code
 * SIMULATED} gets that device. Each service has its own random stream.
 */
public final class SimulatedSensors {
  private static final double RECEIVER_REACH_M = 20_000.0;

  private final long seed;
  private final LocalPlane plane;
  private final Supplier<Moment> now;
  private Supplier<List<SimulatedTraffic.Other>> others = List::of;
  private GpsParameters receiver = GpsParameters.survey();

  /**
   * Creates sensors for a vehicle.
   *
   * @param vehicle the vehicle they are mounted on
   * @param wind velocity of the surrounding air: east, north, up [m/s]
   */
  public record Moment(VehicleTruth vehicle, Point wind) {}

  /**
   * @param plane plane of the true positions
   * @param now the ground truth, called on the reading service's thread
   */
  public SimulatedSensors(long seed, LocalPlane plane, Supplier<Moment> now) {
    this.seed = seed;
    this.plane = plane;
    this.now = now;
  }

  /** Sets the grade of GNSS receivers instead of survey grade. */
  public SimulatedSensors receiver(GpsParameters grade) {
    receiver = grade;
    return this;
  }

  /** Adds other traffic for traffic receivers. */
  public SimulatedSensors traffic(Supplier<List<SimulatedTraffic.Other>> around) {
    others = around;
    return this;
  }

  /** Registers the simulated sensors with the launcher. */
  public void attach(LaunchOptions launch) {
    make(launch, GpsSensor.class, "RECEIVER", GpsSensor::new, c -> new GpsSensor(c, gps(c)));
    make(
        launch,
        CompassSensor.class,
        "COMPASS",
        CompassSensor::new,
        c -> new CompassSensor(c, compass(c)));
    make(launch, ImuSensor.class, "IMU", ImuSensor::new, c -> new ImuSensor(c, imu(c)));
    make(
        launch,
        BarometerSensor.class,
        "BAROMETER",
        BarometerSensor::new,
        c -> new BarometerSensor(c, barometer(c)));
    make(
        launch,
        AirspeedSensor.class,
        "PITOT TUBE",
        AirspeedSensor::new,
        c -> new AirspeedSensor(c, pitotTube(c)));
    make(
        launch,
        TrafficSensor.class,
        "RECEIVER",
        TrafficSensor::new,
        c -> new TrafficSensor(c, traffic(c)));
  }

  private static <S extends U2SAService> void make(
      LaunchOptions launch,
      Class<S> service,
      String variable,
      Function<ServiceContext, S> configured,
      Function<ServiceContext, S> simulated) {
    launch.making(
        service,
        context ->
            stated(context, variable).filter(name -> !name.equals(Devices.SIMULATED)).isPresent()
                ? configured.apply(context)
                : simulated.apply(context));
  }

  /** Value of a variable in the service's file, or empty. */
  private static Optional<Object> stated(ServiceContext context, String variable) {
    return context.configuration().enumerateFields().stream()
        .filter(each -> each.getKey().equals(variable))
        .map(Map.Entry::getValue)
        .findFirst();
  }

  private NoiseStreams streams(ServiceContext context, String service) {
    String name = stated(context, "SERVICE NAME").map(Object::toString).orElse(service);
    return new NoiseStreams(new NoiseStreams(seed).of("sensor " + name).nextLong());
  }

  private VehicleTruth truth() {
    return now.get().vehicle();
  }

  private double altitudeM() {
    Point place = truth().position();
    return plane.at(place.x(), place.y(), place.z()).altitudeM();
  }

  /** Sets the service's DELAY to the receiver's latency unless its file sets it. */
  private SimulatedGps gps(ServiceContext context) {
    unlessStated(context, "DELAY", receiver.latencyS());
    NoiseStreams streams = streams(context, "GpsSensor");
    return new SimulatedGps(receiver, plane, streams, this::truth, () -> false);
  }

  private SimulatedCompass compass(ServiceContext context) {
    Geodetic origin = plane.origin();
    double declinationRad =
        MagneticModel.declinationRad(
            origin.latitudeDeg(),
            origin.longitudeDeg(),
            origin.altitudeM(),
            MagneticModel.FIRST_YEAR);
    return new SimulatedCompass(
        CompassParameters.calibrated(declinationRad),
        streams(context, "CompassSensor"),
        this::truth,
        CompassModel.Disturbance::none);
  }

  private SimulatedImu imu(ServiceContext context) {
    return new SimulatedImu(
        SimulatedImu.Errors.vn100(),
        streams(context, "ImuSensor"),
        () -> SimulatedImu.readingOf(truth()));
  }

  private SimulatedBarometer barometer(ServiceContext context) {
    return new SimulatedBarometer(
        SensorErrors.barometer(),
        PressureAltitude.SEA_LEVEL_PA,
        streams(context, "BarometerSensor"),
        this::altitudeM);
  }

  private SimulatedPitotTube pitotTube(ServiceContext context) {
    return new SimulatedPitotTube(
        SensorErrors.pitotTube(),
        streams(context, "AirspeedSensor"),
        this::truth,
        () -> now.get().wind(),
        this::altitudeM);
  }

  private SimulatedTraffic traffic(ServiceContext context) {
    return new SimulatedTraffic(
        SensorErrors.transponder(),
        RECEIVER_REACH_M,
        plane,
        streams(context, "TrafficSensor"),
        () -> truth().position(),
        others);
  }

  private static void unlessStated(ServiceContext context, String variable, double value) {
    XmlConfiguration configuration = context.configuration();
    if (stated(context, variable).isEmpty()) {
      configuration.override(variable, value);
    }
  }
}
