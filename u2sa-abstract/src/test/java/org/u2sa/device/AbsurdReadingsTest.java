package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.device.payload.PingerSensor;
import org.u2sa.device.payload.ThrustSensor;
import org.u2sa.device.port.Anemometer;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.MotorController;
import org.u2sa.device.port.Orientation;
import org.u2sa.device.port.PitotTube;
import org.u2sa.device.port.PointScanner;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.port.RangeFinder.Distance;
import org.u2sa.device.port.Sonar;
import org.u2sa.device.port.Thruster;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.device.port.TrafficReceiver.Traffic;
import org.u2sa.device.port.VelocityLog.Speeds;
import org.u2sa.device.port.WheelEncoder.Ticks;
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
  private static final String LOAD_CELL = "load cell"; // the only one that needs a variable

  private final Map<String, Function<ServiceContext, U2SAService>> services = new TreeMap<>();

  /** A device whose readings consist of random ones of the values above. */
  private static final class Absurd<R extends Device.Reading> {
    private final Random random = new Random(20L);
    private final Class<R> type;

    Absurd(Class<R> type) {
      this.type = type;
    }

    Optional<R> read(long nowMicros) {
      return Optional.of(record(type, nowMicros));
    }

    private <T> T record(Class<T> record, long nowMicros) {
      Constructor<?> canonical =
          Stream.of(record.getConstructors())
              .max(Comparator.comparing(Constructor::getParameterCount))
              .orElseThrow();
      Object[] values =
          Stream.of(canonical.getGenericParameterTypes())
              .map(part -> value(part, nowMicros))
              .toArray();
      try {
        return record.cast(canonical.newInstance(values));
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException(e);
      }
    }

    private Object value(Type part, long nowMicros) {
      if (part instanceof ParameterizedType of) {
        Class<?> element = (Class<?>) of.getActualTypeArguments()[0];
        Optional<?> one =
            element == Point.class ? point() : Optional.of(record(element, nowMicros));
        return of.getRawType() == Optional.class ? one : one.stream().toList();
      }
      if (part == OptionalDouble.class) {
        return random.nextInt(4) == 0 ? OptionalDouble.empty() : OptionalDouble.of(number());
      }
      return switch (((Class<?>) part).getSimpleName()) {
        case "long" -> nowMicros;
        case "double" -> number();
        case "int" -> random.nextInt();
        case "boolean" -> random.nextBoolean();
        case "String" -> "4B1234";
        case "byte[]" -> new byte[] {-1, 0, -1};
        default -> record((Class<?>) part, nowMicros);
      };
    }

    private double number() {
      return VALUES[random.nextInt(VALUES.length)];
    }

    private Optional<Point> point() {
      try {
        return Optional.of(Point.of(number(), number(), number()));
      } catch (IllegalArgumentException e) {
        return Optional.empty(); // a driver cannot make such a point either
      }
    }
  }

  private <R extends Device.Reading> void add(
      String name, Class<R> reading, BiFunction<ServiceContext, Absurd<R>, U2SAService> service) {
    services.put(name, context -> service.apply(context, new Absurd<>(reading)));
  }

  @BeforeEach
  void addAll() {
    add("barometer", Pressure.class, (c, device) -> new BarometerSensor(c, device::read));
    add("depth gauge", Pressure.class, (c, device) -> new DepthSensor(c, device::read));
    add("pitot tube", PitotTube.Impact.class, (c, device) -> new AirspeedSensor(c, device::read));
    add("compass", Heading.class, (c, device) -> new CompassSensor(c, device::read));
    add("IMU", Orientation.class, (c, device) -> new ImuSensor(c, device::read));
    add("GPS", GpsFix.class, (c, device) -> new GpsSensor(c, device::read));
    add("range finder", Distance.class, (c, device) -> new RangeSensor(c, device::read));
    add("sonar", Sonar.Ping.class, (c, device) -> new SonarSensor(c, device::read));
    add("velocity log", Speeds.class, (c, device) -> new WaterSpeedSensor(c, device::read));
    add("traffic", Traffic.class, (c, device) -> new TrafficSensor(c, device::read));
    add(
        "hydrophones",
        HydrophoneArray.Ping.class,
        (c, device) -> new PingerSensor(c, now -> device.read(now).map(ping -> ping)));
    add(LOAD_CELL, LoadCell.Load.class, (c, device) -> new ThrustSensor(c, device::read));
    add("anemometer", Anemometer.Wind.class, (c, device) -> new WindSensor(c, device::read));
    add(
        "3-D scanner",
        PointScanner.Cloud.class,
        (c, device) -> new PointCloudSensor(c, device::read));
    add("radar", TrackingRadar.Tracks.class, (c, device) -> new RadarSensor(c, device::read));
    add("wheel encoder", Ticks.class, (c, device) -> new WheelEncoderSensor(c, device::read));
    add(
        "thruster",
        Thruster.Turning.class,
        (c, device) -> new ThrusterActuator(c, new AbsurdThruster(device)));
    add(
        "motor controller",
        MotorController.Counts.class,
        (c, device) -> new WheelMotors(c, new AbsurdController(device)));
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
    return services.entrySet().stream()
        .map(
            each ->
                DynamicTest.dynamicTest(
                    each.getKey(), () -> survives(each.getKey(), each.getValue())));
  }

  private static void survives(String name, Function<ServiceContext, U2SAService> service) {
    try (ServiceKit kit = new ServiceKit()) {
      if (name.equals(LOAD_CELL)) {
        kit.with("MASS", 10.0);
      }
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
