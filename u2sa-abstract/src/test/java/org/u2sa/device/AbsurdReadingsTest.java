package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.u2sa.device.port.Anemometer;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.MotorController;
import org.u2sa.device.port.Orientation;
import org.u2sa.device.port.PitotTube;
import org.u2sa.device.port.PointScanner;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.device.port.Sonar;
import org.u2sa.device.port.Thruster;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/**
 * Values that no message takes, from any device: the reading is dropped and the service goes on.
 */
class AbsurdReadingsTest {
  private static final double[] VALUES = {
    Double.NaN,
    Double.POSITIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    1e300,
    -1e300,
    1e16,
    -1e16,
    -1.0,
    0.0,
    1.0,
    Double.MIN_VALUE
  };
  private static final double SECONDS = 30.0;

  private final Map<String, Function<ServiceContext, U2SAService>> services = new TreeMap<>();

  /** A device's readings: random ones of the values above. */
  private static final class Absurd<R extends Device.Reading> {
    private final Random random = new Random(20L);
    private final BiFunction<Absurd<R>, Long, R> reading;

    Absurd(BiFunction<Absurd<R>, Long, R> reading) {
      this.reading = reading;
    }

    Optional<R> read(long nowMicros) {
      return Optional.of(reading.apply(this, nowMicros));
    }

    double number() {
      return VALUES[random.nextInt(VALUES.length)];
    }

    OptionalDouble some() {
      return random.nextInt(4) == 0 ? OptionalDouble.empty() : OptionalDouble.of(number());
    }

    Optional<Point> point() {
      try {
        return Optional.of(Point.of(number(), number(), number()));
      } catch (IllegalArgumentException e) {
        return Optional.empty(); // a driver cannot make such a one either
      }
    }
  }

  private <R extends Device.Reading> void add(
      String name,
      BiFunction<ServiceContext, Absurd<R>, U2SAService> service,
      BiFunction<Absurd<R>, Long, R> reading) {
    services.put(name, context -> service.apply(context, new Absurd<>(reading)));
  }

  private void addSensors() {
    this.<Pressure>add(
        "barometer",
        (context, device) -> new BarometerSensor(context, (Barometer) device::read),
        (absurd, now) -> new Pressure(now, absurd.number(), absurd.some()));
    this.<Pressure>add(
        "depth gauge",
        (context, device) -> new DepthSensor(context, (DepthGauge) device::read),
        (absurd, now) -> new Pressure(now, absurd.number(), absurd.some()));
    this.<PitotTube.Impact>add(
        "pitot tube",
        (context, device) -> new AirspeedSensor(context, (PitotTube) device::read),
        (absurd, now) -> new PitotTube.Impact(now, absurd.number(), absurd.some(), absurd.some()));
    this.<Heading>add(
        "compass",
        (context, device) -> new CompassSensor(context, (Compass) device::read),
        (absurd, now) -> new Heading(now, absurd.number(), absurd.random.nextBoolean()));
    this.<Orientation>add(
        "IMU",
        (context, device) -> new ImuSensor(context, (Imu) device::read),
        (absurd, now) ->
            new Orientation(
                now,
                absurd.number(),
                absurd.number(),
                new Heading(now, absurd.number(), true),
                absurd.number(),
                absurd.number(),
                absurd.number(),
                absurd.point()));
    this.<GpsFix>add(
        "GPS",
        (context, device) -> new GpsSensor(context, (GpsReceiver) device::read),
        (absurd, now) ->
            new GpsFix(
                now,
                absurd.number(),
                absurd.number(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                -1,
                true));
    this.<RangeFinder.Distance>add(
        "range finder",
        (context, device) -> new RangeSensor(context, (RangeFinder) device::read),
        (absurd, now) -> new RangeFinder.Distance(now, absurd.some()));
    this.<Sonar.Ping>add(
        "sonar",
        (context, device) -> new SonarSensor(context, (Sonar) device::read),
        (absurd, now) ->
            new Sonar.Ping(now, absurd.number(), absurd.number(), new byte[] {-1, 0, -1}));
    this.<VelocityLog.Speeds>add(
        "velocity log",
        (context, device) -> new WaterSpeedSensor(context, (VelocityLog) device::read),
        (absurd, now) ->
            new VelocityLog.Speeds(
                now,
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some(),
                absurd.some()));
    this.<TrafficReceiver.Traffic>add(
        "traffic",
        (context, device) -> new TrafficSensor(context, (TrafficReceiver) device::read),
        (absurd, now) ->
            new TrafficReceiver.Traffic(
                now,
                List.of(
                    new TrafficTarget(
                        "4B1234",
                        "",
                        "",
                        now,
                        absurd.number(),
                        absurd.number(),
                        absurd.some(),
                        absurd.random.nextBoolean(),
                        absurd.point(),
                        absurd.some()))));
    this.<Anemometer.Wind>add(
        "anemometer",
        (context, device) -> new WindSensor(context, (Anemometer) device::read),
        (absurd, now) -> new Anemometer.Wind(now, absurd.number(), absurd.number()));
    this.<PointScanner.Cloud>add(
        "3-D scanner",
        (context, device) -> new PointCloudSensor(context, (PointScanner) device::read),
        (absurd, now) -> new PointScanner.Cloud(now, absurd.point().stream().toList()));
    this.<TrackingRadar.Tracks>add(
        "radar",
        (context, device) -> new RadarSensor(context, (TrackingRadar) device::read),
        (absurd, now) ->
            new TrackingRadar.Tracks(
                now,
                List.of(
                    new TrackingRadar.Track(
                        "1",
                        now,
                        absurd.number(),
                        new TrackingRadar.Direction(absurd.number(), true),
                        absurd.some(),
                        absurd.some(),
                        Optional.of(new TrackingRadar.Direction(absurd.number(), true))))));
    this.<WheelEncoder.Ticks>add(
        "wheel encoder",
        (context, device) -> new WheelEncoderSensor(context, (WheelEncoder) device::read),
        (absurd, now) ->
            new WheelEncoder.Ticks(now, absurd.random.nextInt(), absurd.random.nextInt()));
  }

  private void addActuators() {
    this.<Thruster.Turning>add(
        "thruster",
        (context, device) -> new ThrusterActuator(context, new AbsurdThruster(device)),
        (absurd, now) ->
            new Thruster.Turning(now, absurd.some(), absurd.some(), absurd.some(), absurd.some()));
    this.<MotorController.Counts>add(
        "motor controller",
        (context, device) -> new WheelMotors(context, new AbsurdController(device)),
        (absurd, now) ->
            new MotorController.Counts(
                now, absurd.random.nextInt(), absurd.random.nextInt(), absurd.some()));
  }

  private record AbsurdThruster(Absurd<Turning> device) implements Thruster {
    @Override
    public Optional<Turning> read(long nowMicros) {
      return device.read(nowMicros);
    }

    @Override
    public void thrust(double percent) {}

    @Override
    public void stop(long nowMicros) {}

    @Override
    public void leave() {}

    @Override
    public void close() {}
  }

  private record AbsurdController(Absurd<Counts> device) implements MotorController {
    @Override
    public Optional<Counts> read(long nowMicros) {
      return device.read(nowMicros);
    }

    @Override
    public void drive(double first, double second) {}

    @Override
    public boolean turn(double firstPerS, double secondPerS) {
      return false;
    }

    @Override
    public void stop(long nowMicros) {}

    @Override
    public void leave() {}

    @Override
    public void close() {}
  }

  @TestFactory
  Stream<DynamicTest> step_absurdReadings_areDroppedAndTheServiceGoesOn() {
    addSensors();
    addActuators();
    return services.entrySet().stream()
        .map(each -> DynamicTest.dynamicTest(each.getKey(), () -> survives(each.getValue())));
  }

  private static void survives(Function<ServiceContext, U2SAService> service) {
    try (ServiceKit kit = new ServiceKit()) {
      kit.start(service);
      kit.publish( // a radar places its targets from there
          Channels.STATE,
          new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(8.0).y(47.0).psi(1.0));
      kit.advance(SECONDS);
      HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
      assertThat(health.exceptions()).as("exceptions; %s", health.lastError()).isZero();
      assertThat(health.status()).isEqualTo(ServiceStatus.RUNNING);
    }
  }

  @TestFactory
  Stream<DynamicTest> mapped_valueThatNoMessageTakes_isCountedAndReportedWithItsReason() {
    addActuators();
    addSensors();
    return Stream.of("depth gauge", "pitot tube", "GPS", "thruster", "motor controller")
        .map(name -> DynamicTest.dynamicTest(name, () -> reports(services.get(name))));
  }

  private static void reports(Function<ServiceContext, U2SAService> service) {
    try (ServiceKit kit = new ServiceKit()) {
      U2SAService started = kit.start(service);
      kit.advance(SECONDS);
      assertThat(kit.log(started.getServiceName()))
          .anyMatch(line -> line.contains("sent invalid data") && line.contains("expected"))
          .filteredOn(line -> line.contains("sent invalid data"))
          .hasSizeLessThan(20); // 1, 2, 4, 8…
    }
  }
}
